// Whether impulses move a vertex in the substep in which they act. After an implicit solve of obstacles and pairs they
// change its velocity alone: its springs are in balance, and to move it without its neighbours stretches them by far
// more energy than the impulse takes. The next substep moves all of them. What an obstacle strikes would be in it by
// then, and cloth that other cloth bears has no other hold: these go along.
// Source: docs/contact.md, Impulse.
override kMove : bool = true;  // false: SolvedContact::balances

fn impulses_move(held : u32) -> bool { return kMove || (held & (kBesideCloth | kStruck)) != 0u; }
