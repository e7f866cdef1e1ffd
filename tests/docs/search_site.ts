// Asks the search of a site, in Chromium: node tests/docs/search_site.ts PAGE QUESTION...
// Prints, as JSON, the addresses that it finds for each question, best first, and what the page should not have done:
// its errors, and its requests to other places than its own.
import { launch } from "../web/chromium.ts";

const [start = "", ...questions] = process.argv.slice(2);
const own = start.startsWith("file:") ? "file://" : new URL(start).origin;
const browser = await launch([], process.env["CHROMIUM"]);
const page = await browser.newPage();
const complaints: string[] = [];
page.on("console", (message) => {
  if (message.type() === "error") complaints.push(message.text());
});
page.on("pageerror", (error) => complaints.push(error.message));
page.on("request", (request) => {
  if (!request.url().startsWith(own) && !request.url().startsWith("data:")) complaints.push(request.url());
});

await page.goto(start);
const box = page.locator(".md-search__input");
await box.click();
const state = page.locator(".md-search-result__meta");
const found: Record<string, string[]> = {};
for (const question of questions) {
  await box.fill("");
  await box.press("End"); // the page listens to keys
  await state.filter({ hasText: "Type to start" }).waitFor();
  await box.fill(question);
  await box.press("End");
  await state.filter({ hasText: "matching document" }).waitFor();
  found[question] = await page.$$eval(".md-search-result__link", (links) =>
    links.map((link) => link.getAttribute("href")!));
}
await browser.close();
console.log(JSON.stringify({ found, complaints }));
