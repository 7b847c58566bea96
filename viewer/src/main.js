// The page of `roomwright view` begins here.
import { Http } from './server/http.js';
import { Server } from './server/server.js';
import { openViewer } from './viewer.js';

openViewer(new Server(new Http()));
