// SPDX-License-Identifier: BSD-3-Clause
// Fills the sections of page.html from the page's JSON. A section is a function below; it returns whether there is
// anything to show. `readGlb` and `showModel` are in model.js, tables in texts.js.
(function () {
  'use strict';
  const data = JSON.parse(document.getElementById('data').textContent);
  const report = data.report, plan = data.plan || { rooms: [], storeys: [] };
  const rooms = (report.rooms || []).length ? report.rooms : plan.rooms;
  const storeys = plan.storeys || [], distances = (report.evaluation || {}).cloud_to_mesh;
  const byId = id => document.getElementById(id);

  // ---- Head ----

  function head() {
    document.title = data.name ? 'Model: ' + data.name : 'Model of an indoor scan';
    byId('title').textContent = document.title;
    const input = report.input || {};
    byId('source').textContent = [input.path && 'Scan: ' + input.path, input.points && number(input.points) + ' points',
      input.unit && input.unit !== 1 && 'unit ' + input.unit + ' m'].filter(Boolean).join(', ');
    const figures = [];
    if (rooms.length) {
      figures.push([rooms.length === 1 ? 'room' : 'rooms', rooms.length]);
      if (storeys.length > 1) figures.push(['storeys', storeys.length]);
      figures.push(['floor area', number(sum(rooms, room => room.area), 1) + '\u00a0m²'],
        ['volume', number(sum(rooms, room => room.volume), 1) + '\u00a0m³']);
      const meshes = rooms.map(room => room.mesh).filter(Boolean); // an edited room has none
      if (meshes.length) figures.push(['closed meshes', meshes.filter(mesh => mesh.closed_manifold).length + ' of ' + meshes.length]);
    }
    if (report.support) figures.push(['of the walls measured', percent(report.support.measured)],
      ['inferred', percent(report.support.inferred)], ['seen by nobody', percent(report.support.unseen)]);
    const stated = statedAccuracy('walls', 'measured');
    if (stated) figures.push([`of the walls measured to ${stated.level} or better`, percent(stated.share)]);
    for (const noise of (report.noise || []).filter(storey => storey.stretches).sort((a, b) => b.measured - a.measured).slice(0, 1))
      figures.push([`noise of walls, correlated over ${number(100 * noise.correlation)}\u00a0cm`, centimetres(noise.measured)]);
    if (distances && distances.count) figures.push(['half the points within', centimetres(distances.median)],
      ['within 5\u00a0cm', percent(distances.within_5cm)]);
    byId('figures').append(...figures.map(([name, value]) =>
      make('div', {}, make('dt', {}, name), make('dd', {}, String(value)))));
  }

  // ---- Accuracy ----

  const levels = ['LOA50', 'LOA40', 'LOA30', 'LOA20', 'LOA10'], notMeasured = 'not measured';

  // The finest level that nine tenths of what was measured of a kind reach, and the share of all of the kind that do.
  function statedAccuracy(kind, what) {
    const counts = ((report.accuracy || {})[kind] || {})[what] || {}, all = sum(Object.values(counts), count => count);
    let reached = 0;
    for (const level of levels)
      if ((reached += counts[level] || 0) > 0 && reached >= 0.9 * (all - (counts[notMeasured] || 0)))
        return { level, share: reached / all };
    return null;
  }

  function accuracy(section) {
    const rows = Object.entries(report.accuracy || {}).flatMap(([kind, found]) => Object.keys(found).map(what => ({ kind, what, counts: found[what] })));
    const sentences = ['measured', 'represented'].map(what => [what, statedAccuracy('walls', what)]).filter(([, stated]) => stated)
      .map(([what, { level, share }]) => `${percent(share)} of the walls are ${what} to ${level} or better.`);
    section.querySelector('.summary').append(sentences.join(' '));
    section.querySelector('.wide').append(table([['of', row => row.kind, 'text'], ['accuracy', row => row.what, 'text'],
      ...[...levels, notMeasured].map(level => [level, row => row.counts[level] || ''])], rows));
    return rows.length > 0;
  }

  // ---- Doubts ----

  const marks = []; // places of doubts and of what was confirmed, drawn on the plan

  const markOf = door => door.number ? ({ door: 'D', window: 'W', passage: 'P' }[door.kind] || 'O') + door.number : '';

  // What somebody looked at and found right: names, rooms and places.
  function confirmed() {
    const named = (name, room, { start, end }) => ({ number: '✓', text: name + ' is confirmed', name, room, at: [0, 1].map(k => (start[k] + end[k]) / 2) });
    const walls = plan.rooms.flatMap(room => (room.boundary || []).map((wall, k) => wall.confirmed && named(`wall ${room.id}.${k + 1}`, room.id, wall)));
    const openings = (plan.openings || []).map(door => door.confirmed && named(`${door.kind} ${markOf(door)}`, Math.max(...door.rooms), door));
    return [...walls, ...openings].filter(Boolean);
  }

  // What puts most at stake comes first; report.json says how many to show.
  function check(section) {
    const list = section.querySelector('ul'), all = report.doubts || [], { text, shown = all.length } = report.verdict || {};
    if (text) section.querySelector('.verdict').append(text[0].toUpperCase() + text.slice(1) + '.');
    list.before(...(report.remarks || []).map(remark => make('p', { class: 'remark' }, remark[0].toUpperCase() + remark.slice(1) + '.')));
    const item = ({ text, stake }, ...more) => make('li', {}, text, ...more,
      ...(stake ? [make('span', { class: 'remedy' }, `${number(stake, 2)}\u00a0m² at stake`)] : []));
    for (const told of all.slice(0, shown)) {
      if (told.at) marks.push({ number: marks.length + 1, ...told });
      list.append(item(told, ...(told.at ? [make('span', { class: 'mark' }, String(marks.length))] : [])));
    }
    if (all.length > shown)
      list.append(make('li', {}, make('details', {}, make('summary', {}, `${all.length - shown} more places where less is at stake`),
        make('ul', {}, ...all.slice(shown).map(told => item(told))))));
    const right = confirmed();
    marks.push(...right);
    if (right.length)
      list.append(make('li', { class: 'fine' }, 'Somebody looked and confirmed: ' + right.map(({ name }) => name).join(', ') + '.'));
    if (!all.length)
      list.append(report.verdict ? make('li', { class: 'fine' }, 'Nothing is doubted.') : make('li', {}, 'There is no report.json that tells what to doubt.'));
    return true;
  }

  // ---- Sections ----

  function coverage(section) {
    const found = report.coverage;
    if (!found) return false;
    section.querySelector('.summary').append(`${number(found.modelled, 1)}\u00a0m² of ${number(found.seen, 1)}\u00a0m² of `
      + `floor that was seen are in the plan, ${percent(found.share)}.`);
    section.querySelector('.note').hidden = !found.left_out.length;
    if (found.left_out.length)
      section.querySelector('.wide').append(table([
        ['left out', gap => gap.reason, 'text'], ['area, m²', gap => number(gap.area, 1)],
        ['around x, y, m', gap => gap.at.map(place => number(place, 1)).join(', ')],
        ['z, m', gap => number(gap.floor, 1) + ' to ' + number(gap.ceiling, 1)],
        ['counts', gap => gap.counts ? 'yes' : 'no', 'text']], found.left_out));
    return true;
  }

  const range = values => [...new Set([Math.min(...values), Math.max(...values)].map(value => number(value, 2)))].join(' to ');
  const roomsOf = storey => rooms.filter(room => storey.rooms.includes(room.id));

  function storeyTable(section) {
    section.querySelector('.wide').append(table([
      ['storey', storey => storey.name, 'text'], ['rooms', storey => roomsOf(storey).length],
      ['floor at z, m', storey => number(storey.floor, 2)], ['height, m', storey => range(roomsOf(storey).map(room => room.height))],
      ['area, m²', storey => number(sum(roomsOf(storey), room => room.area), 2)],
      ['volume, m³', storey => number(sum(roomsOf(storey), room => room.volume), 2)]], storeys));
    return storeys.length > 1;
  }

  // The texts of a sheet: x, y, half width and half height, as shares of the sheet.
  function textsOf(svg) {
    const root = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
    const [across, up] = ['width', 'height'].map(name => parseFloat(root.getAttribute(name)));
    return [...root.getElementsByTagName('text')].map(text => {
      const [x, y, font] = ['x', 'y', 'font-size'].map(name => +text.getAttribute(name)), half = 0.28 * font * text.textContent.length;
      const turn = (/rotate\((-?[\d.]+)/.exec(text.getAttribute('transform')) || [0, 0])[1] * Math.PI / 180;
      const [c, d] = [Math.abs(Math.cos(turn)), Math.abs(Math.sin(turn))];
      return [x / across, y / up, (c * half + d * font / 2) / across, (d * half + c * font / 2) / up];
    });
  }

  // The place nearest to one at which a mark lies on no text and no other mark.
  const across = 0.009, up = 0.013, turns = Array.from({ length: 400 }, (_, k) => [Math.sqrt(k) / 2, 2.4 * k]);
  function freePlace(taken, [x, y]) {
    const place = turns.map(([off, turn]) => [x + across * off * Math.cos(turn), y + up * off * Math.sin(turn)]).find(([u, v]) =>
      taken.every(([mx, my, a, b]) => Math.abs(u - mx) > a + across || Math.abs(v - my) > b + up)) || [x, y];
    taken.push([...place, across, up]);
    return place;
  }

  function drawings(section) {
    const box = section.querySelector('input'), places = data.scan && data.scan.is_scan ? readScan(data.scan).corners : [];
    box.parentElement.hidden = !places.length;
    box.addEventListener('change', () => section.classList.toggle('sliced', box.checked));
    section.classList.toggle('sliced', box.checked);
    for (const drawing of data.drawings) {
      if (data.drawings.length > 1) section.querySelector('.plans').append(make('h3', {}, drawing.name));
      const sheet = make('div', { class: 'sheet' }, make('img', {
        alt: 'Plan: ' + drawing.name, src: 'data:image/svg+xml,' + encodeURIComponent(drawing.svg) }), slice(drawing, places));
      const taken = textsOf(drawing.svg);
      for (const { number, at, room, text } of marks)
        if (!room || drawing.rooms.includes(room)) {
          const [x, y] = freePlace(taken, onSheet(drawing, at));
          sheet.append(make('span', { class: number === '✓' ? 'mark fine' : 'mark', title: text, style: `left:${100 * x}%;top:${100 * y}%` }, String(number)));
        }
      section.querySelector('.plans').append(sheet);
    }
    section.querySelector('.doors').textContent = (plan.openings || []).length
      ? 'Gaps: passages; a swing or a line across: doors, by whether the leaf was seen open; double lines: windows.'
      : 'No doors or windows were found; where there are some, a wall is drawn.';
    return data.drawings.length > 0;
  }

  const roomColumns = [
    ['room', room => [room.id, (plan.names || {})[room.id]].filter(Boolean).join(' ')], ['area, m²', room => number(room.area, 2)],
    ['perimeter, m', room => number(room.perimeter, 2)], ['height, m', room => number(room.height, 2)],
    ['volume, m³', room => number(room.volume, 2)], ['wall surface, m²', room => number((room.solid || {}).wall_area, 2)],
    ['walls', room => countOf(room.walls || room.boundary)], ['columns', room => countOf(room.columns)],
    ['ceiling details', room => countOf(room.details)], ['walls measured', room => percent((room.support || {}).measured)],
    ['mesh', room => closed(room.mesh)], ['solid', room => closed(room.solid)]];
  const countOf = list => String(Array.isArray(list) ? list.length : list || 0); // the plan has lists, the report numbers

  function roomTables(section) {
    const tables = section.querySelector('.tables');
    if (storeys.length < 2)
      tables.append(table(roomColumns, rooms));
    else {
      const others = rooms.filter(room => !storeys.some(storey => storey.rooms.includes(room.id)));
      for (const storey of storeys) tables.append(make('h3', {}, storey.name), table(roomColumns, roomsOf(storey)));
      if (others.length) tables.append(make('h3', {}, 'not in the plan'), table(roomColumns, others));
    }
    return rooms.length > 0;
  }

  function openings(section) {
    const found = plan.openings || [], name = room => room ? 'room ' + room : 'outside';
    const { columns = [], rows = [] } = (report.certainty || {}).openings || {};
    const sure = door => (rows.find(row => row[0] === markOf(door)) || [])[columns.indexOf('within_5cm')];
    const told = door => (report.openings || []).find(row => row.number === markOf(door)) || {};
    const length = door => Math.hypot(door.end[0] - door.start[0], door.end[1] - door.start[1]);
    if (found.length)
      section.querySelector('.wide').append(table([['number', door => markOf(door)], ['kind', door => door.kind, 'word'],
        ['between', door => door.rooms.map(name).join(' and '), 'text'],
        ['walls', door => (door.walls || []).map(wall => wall.room + '.' + (wall.element + 1)).join(', ')],
        ['at x, y, m', door => [0, 1].map(k => number((door.start[k] + door.end[k]) / 2, 1)).join(', ')],
        ['width, m', door => number(length(door), 2)], ['height, m', door => number(door.top - door.bottom, 2)],
        ['bottom at z, m', door => number(door.bottom, 2)], ['depth, m', door => number(door.depth, 2) + (door.rooms.includes(0) ? ' at least' : '')],
        ['leaf', door => door.kind === 'door' && door.state !== 'unknown' ? door.state : ''],
        ['sure', door => door.confirmed ? 'confirmed' : percent(sure(door))], ['width is', door => told(door).width_is || ''],
        ['its standard error, cm', door => told(door).width_error > 0 ? number(100 * told(door).width_error, 1) : '']], found));
    return found.length > 0;
  }

  function schedules(section) {
    const units = { m: 'm', mm: 'mm', m2: 'm²', m3: 'm³', percent: '%' };
    const titleOf = column => column.replace(/_([^_]*)$/, (end, unit) => unit in units ? ', ' + units[unit] : end).replaceAll('_', ' ');
    const tables = Object.entries(report.schedules || {}).filter(([, { rows }]) => rows.length);
    for (const [name, { columns, rows }] of tables)
      section.append(make('details', {}, make('summary', {}, `${name}: ${rows.length}`),
        table(columns.map((column, k) => [titleOf(column), row => row[k]]), rows)));
    return tables.length > 0;
  }

  // What the scan shows of each wall, a picture a wall, below the name of its room.
  function walls(section) {
    const states = { s: ['#9b9b9b', 'seen'], w: ['#d8302c', 'within the wall'], t: ['#eb9795', 'rays through'], h: ['#96b8e1', 'hidden'], e: ['#fae28c', 'nothing'] };
    const maps = report.walls || [], place = section.querySelector('.walls'), scale = 3, metre = 30;
    const counted = (count, word) => `${count} ${word}${count === 1 ? '' : 's'}`;
    const drawn = map => {
      const canvas = make('canvas', { width: scale * map.columns, height: scale * map.rows,
        style: `width:${Math.round(metre * map.columns * map.cell)}px` });
      const pen = canvas.getContext('2d');
      let at = 0;
      for (const [, length, state] of map.cells.matchAll(/(\d+)(\w)/g))
        for (let k = 0; k < +length; ++k, ++at) {
          if (!states[state]) continue;
          pen.fillStyle = states[state][0];
          pen.fillRect(scale * (at % map.columns), scale * Math.floor(at / map.columns), scale, scale);
        }
      const x = along => scale * along / map.cell, y = z => scale * (map.rows - (z - map.base) / map.cell);
      pen.lineWidth = 2;
      for (const opening of map.openings)
        pen.strokeRect(x(opening.from), y(opening.top), x(opening.to) - x(opening.from), y(opening.bottom) - y(opening.top));
      const kinds = map.openings.map(opening => ', ' + opening.kind).join('');
      const name = map.walls.length ? 'wall ' + map.walls.map(wall => map.room + '.' + wall).join(', ') : 'a column';
      return make('figure', {}, canvas, make('figcaption', {}, `${name}: ${number(map.length, 1)} m${kinds}`));
    };
    for (const room of [...new Set(maps.map(map => map.room))]) {
      const own = maps.filter(map => map.room === room), count = sum(own, map => map.openings.length), shown = sum(own, map => map.walls.length);
      const all = countOf((rooms.find(other => other.id === room) || {}).walls), of = +all > shown ? `${shown} of ` : '';
      const box = make('details', {}, make('summary', {}, `room ${room}: ${of}${counted(+all || shown, 'wall')}, ${counted(count, 'opening')}`));
      box.addEventListener('toggle', () => box.children.length > 1 || box.append(...own.map(drawn)), { once: true });
      place.append(box);
    }
    fillKey(section.querySelector('.key'), Object.values(states));
    return maps.length > 0;
  }

  const labelKey = Object.entries(data.colours.labels).filter(([label]) => label !== 'other')
    .map(([label, colour]) => [colour, label]);

  function model(section) {
    fillKey(section.querySelector('.key'), labelKey);
    const { mesh, solid } = data.models;
    if (mesh && mesh.shown < mesh.triangles) {
      byId('thinned').textContent = `The mesh is thinned for this page, from ${number(mesh.triangles)} to `
        + `${number(mesh.shown)} triangles: mesh.ply has them all.`;
      byId('thinned').hidden = false;
    }
    return Boolean(mesh || solid);
  }

  function pictures(section) {
    fillKey(section.querySelector('.key'), labelKey);
    const hasScan = data.scan && data.scan.is_scan, shown = data.models.solid || data.models.mesh;
    byId('no-scan').hidden = hasScan;
    byId('scan-picture').hidden = !hasScan;
    byId('model-picture').hidden = !shown;
    if (hasScan) byId('scan-picture').querySelector('span').textContent = number(data.scan.points);
    if (shown) byId('model-picture').querySelector('span').textContent = number(shown.triangles);
    return Boolean(data.scan || shown);
  }

  // Bars of the histogram, and one for all beyond its range.
  function chart() {
    const bins = [...distances.histogram, distances.beyond_histogram], step = distances.histogram_range / (bins.length - 1);
    const most = Math.max(...bins) || 1, last = bins.length - 1;
    return bins.map((bin, k) => make('div', { title: `${distance(k * step)} ${k === last ? 'or more' : 'to ' + distance((k + 1) * step)}: `
      + `${(100 * bin / distances.count).toFixed(2)} %` },
    make('i', {}, bin === most ? percent(bin / distances.count) : ''),
    make('b', { style: `height:${180 * bin / most}px;background:${colourOfDistance((k + 0.5) * step)}` }),
    make('span', {}, k === last ? 'more' : k % 4 === 0 ? distance(k * step) : '')));
  }

  const colourOfDistance = metres => data.colours.distances[
    Math.min(data.colours.distances.length - 1, Math.round(metres / data.range * (data.colours.distances.length - 1)))];

  function distanceSection(section) {
    const has = distances && distances.count > 0, hasPicture = data.scan && data.scan.distances;
    section.querySelector('.figures').hidden = !has;
    if (has) {
      section.querySelector('.chart').append(...chart());
      section.querySelector('.wide').append(table([['points', d => number(d.count)], ['mean', d => centimetres(d.mean)],
        ['half within', d => centimetres(d.median)], ['95\u00a0% within', d => centimetres(d.p95)],
        ['99\u00a0% within', d => centimetres(d.p99)], ['farthest', d => centimetres(d.max)],
        ['within 1\u00a0cm', d => percent(d.within_1cm)], ['within 5\u00a0cm', d => percent(d.within_5cm)]], [distances]));
    }
    byId('distance-picture').hidden = section.querySelector('.key').hidden = !hasPicture;
    if (hasPicture) {
      byId('distance-picture').querySelector('figcaption').textContent = data.scan.is_scan
        ? 'The thinned scan by its distance from the mesh, ceilings and what is more than 50 cm off left out; furniture is red'
        : 'The refined structure by its distance from the mesh: the scan was not found where this page was written';
      fillKey(section.querySelector('.key'), [0, 1, 2, 3, 4, 5].map(k => [colourOfDistance(data.range * k / 5),
        distance(data.range * k / 5) + (k === 5 ? ' or more' : '')]));
    }
    return Boolean(has || hasPicture);
  }

  const drawn = [['floorplan#', 'floor plan'], ['ceiling#', 'reflected ceiling plan'], ['section_.*', 'section']];
  const knownFiles = [
    ['model.ifc', 'building model, IFC4: rooms, walls, slabs, openings',
      'Revit, Archicad, Allplan, FreeCAD, Blender with Bonsai, IFC viewers'],
    ...drawn.flatMap(([name, what]) => [
      [name + '.dxf', what + ', in metres', 'AutoCAD, BricsCAD, QCAD, LibreCAD'],
      [name + '.pdf', what + ', to scale', 'any PDF viewer'],
      [name + '.svg', what + ', to edit', 'any browser, Inkscape, Illustrator']]),
    ['model.glb', 'sharp model for the web, glTF 2.0', 'Blender, three.js, Windows 3D Viewer, most viewers online'],
    ['solid.obj', 'sharp model, grouped by storey, room and element', 'Blender, SketchUp, Rhino, MeshLab'],
    ['solid.ply', 'sharp model, coloured by label', 'MeshLab, CloudCompare, Blender'],
    ['mesh.ply', 'closed mesh, coloured by label', 'MeshLab, CloudCompare, Blender'],
    ['structure.pcd', 'points of the structure, with label and room', 'CloudCompare, pcl_viewer, pcl_sedr_viewer'],
    ['rooms.csv', 'schedule of rooms', 'Excel, LibreOffice, programs'],
    ['openings.csv', 'schedule of doors, windows and passages', 'Excel, LibreOffice, programs'],
    ['walls.csv', 'schedule of walls', 'Excel, LibreOffice, programs'],
    ['floorplan.json', 'plan, with all figures', 'programs'],
    ['report.json', 'this report', 'programs']];

  function files(section) {
    const rows = knownFiles.flatMap(([name, what, opens]) => {
      const pattern = new RegExp('^' + name.replace(/\.(?=\w+$)/, '\\.').replace('#', '(_\\d+)?') + '$'); // # a storey's number
      return data.files.filter(file => pattern.test(file)).map(file => ({ file, what, opens }));
    });
    section.querySelector('.wide').append(table([['file', row => make('a', { href: row.file }, row.file), 'text'],
      ['what it is', row => row.what, 'text'], ['what opens it', row => row.opens, 'text']], rows));
    return rows.length > 0;
  }

  function stages(section) {
    const rows = report.stages || [], points = count => isNumber(count) ? number(count) : '';
    section.querySelector('.wide').append(table([['stage', row => row.stage, 'text'], ['points in', row => points(row.points_in)],
      ['points out', row => points(row.points_out)], ['seconds', row => number(row.seconds, 2)]],
    [...rows, { stage: 'together', seconds: sum(rows, row => row.seconds) }]));
    return rows.length > 0;
  }

  function parameters(section) {
    const rows = Object.entries(report.parameters || {});
    section.querySelector('.wide').append(table([['parameter', row => make('code', {}, row[0])],
      ['value', row => typeof row[1] === 'string' ? row[1] : JSON.stringify(row[1])]], rows));
    return rows.length > 0;
  }

  head();
  Object.entries({ check, coverage, storeys: storeyTable, plan: drawings, rooms: roomTables, openings, accuracy, schedules, walls, model, pictures,
    distances: distanceSection, files, stages, parameters }).forEach(([id, fill]) => {
    byId(id).hidden = false;
    try {
      if (!fill(byId(id))) byId(id).remove();
    } catch (error) { // a file of another version: the other sections are shown
      console.error(id, error);
      byId(id).remove();
    }
  });
  showModel(data);
  // On paper nothing can be unfolded.
  addEventListener('beforeprint', () => document.querySelectorAll('li details').forEach(folded => { folded.open = true; }));
})();
