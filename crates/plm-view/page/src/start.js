// Starts a page of results.

import { startPage } from "./main.js";

void startPage(null);
