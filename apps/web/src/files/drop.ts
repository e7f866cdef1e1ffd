// Files that are dragged over the page: a hint where they can be dropped, which is everywhere.

const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;

export function acceptDrops(take: (files: readonly File[]) => void): void {
  const hint = document.createElement("div");
  hint.className = "drop-hint";
  hint.hidden = true;
  hint.textContent = "Drop a mesh, a scene or a state to open it";
  document.body.append(hint);

  document.addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault(); // or the browser would go to the file
    hint.hidden = false;
  });
  document.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) hint.hidden = true; // out of the window
  });
  document.addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    hint.hidden = true;
    take([...event.dataTransfer!.files]);
  });
}
