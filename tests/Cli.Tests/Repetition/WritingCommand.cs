namespace Harvester.Cli.Tests.Repetition;

/// <summary>A command that writes to the folder {root}, with its small inputs in {inputs}.</summary>
/// <param name="Name">Name of the case.</param>
/// <param name="Words">The command line.</param>
/// <param name="Before">Command lines that make what the folder holds before.</param>
internal sealed record WritingCommand(string Name, string Words, params string[] Before)
{
    private const string Pairs = "--pair-weathers rain --pair-without nearest-vehicle --pair-ticks 60";
    private const string Small = "--size 64x48 --masks --seed 5 --roads {inputs}/roads.csv";

    /// <summary>Without the check of the camera, which takes a quarter of the time of so small a harvest and writes no file.</summary>
    private const string Unchecked = $"{Small} --max-camera-error 0";

    /// <summary>Whether it replaces something that must be whole until the new is.</summary>
    public bool Replaces => Before.Length == 1;

    /// <summary>Whether it builds a world, which takes longer than all else.</summary>
    public bool BuildsWorld =>
        Words.Split(' ')[0] is "harvest" or "counterfactual" or "drive" or "serve" or "contact-sheet" or "plan"
        || Words.StartsWith("roads photograph", StringComparison.Ordinal);

    /// <summary>Whether others are variants of it: they write through the same code, and to other files.</summary>
    public bool IsBasic => Name is "harvest" or "merge" or "export-kitti";

    /// <summary>A straight road, the file roads.csv of the inputs: its world is built in a fraction of the time of a town.</summary>
    public static string Roads { get; } =
        "harvester roads,1\nnode,0,0,0,-200,30,,,,\nnode,0,1,0,0,30,,,,\nnode,0,2,0,200,30,,,,\nlink,0,1,1,1,0,,200\nlink,1,2,1,1,0,,200\n"
        + "end,3,2\n";

    /// <summary>A list of places, the file places.csv of the inputs.</summary>
    public static string Places { get; } = "name,x,y\nNorth,0,150\n";

    /// <summary>A plan of two trials, the file plan.json of the inputs.</summary>
    public static string Plan { get; } =
        """
            {"name":"two","places":[{"name":"a","x":0,"y":-50}],"weathers":["clear","rain"],"frames":2,
            "cameras":[{"name":"c","width":64,"height":48}],"masks":"rays"}
            """;

    /// <summary>A scenario that the small roads have a place for, the file scenario.json of the inputs.</summary>
    public static string Scenario { get; } =
        """
            {"name":"small","kind":"leader","place":{"metres":30},"ego":{"speed":5},"end":{"seconds":2},
            "actors":[{"id":"a","type":"vehicle","start":{"metresAhead":15}}],
            "events":[{"id":"b","actor":"a","do":{"action":"brake","acceleration":4}}]}
            """;

    /// <summary>A recipe of one export, the file recipe.json of the inputs.</summary>
    public static string Recipe { get; } =
        """{"version":1,"inputs":[{"name":"in"}],"steps":[{"folder":"csv","command":["export","@in","--format","csv"]}]}""";

    /// <summary>
    /// How the paths of the files begin whose operations are the command's own, because another command has all others; null for all.
    /// </summary>
    public IReadOnlyList<string>? Only { get; private init; }

    /// <summary>Whether it is killed at random moments; those with operations of their own only are not, unless this is set.</summary>
    public bool IsKilled
    {
        get => field || Only is null;
        private init;
    }

    /// <summary>Command lines that make the inputs of all commands.</summary>
    public static IReadOnlyList<string> Inputs { get; } =
    [
        $"harvest --out {{inputs}}/session --frames 2 {Small}",
        $"harvest --out {{inputs}}/moving --frames 2 --flow --imu --gnss --birds-eye --occupancy {Small}",
        $"harvest --out {{inputs}}/part-1 --frames 2 --shard 1/2 {Small}",
        $"harvest --out {{inputs}}/part-2 --frames 2 --shard 2/2 {Small}",
        "harvest --out {inputs}/people --frames 1 --pedestrians 5 --size 64x48 --masks --seed 2 --roads {inputs}/roads.csv",
        // The smallest images in which paint can be measured.
        "harvest --out {inputs}/lines --frames 1 --size 320x240 --seed 5 --roads {inputs}/roads.csv",
        $"harvest --out {{inputs}}/pairs --frames 2 {Pairs} {Small}",
        "export {inputs}/session --format gpudrive --roads {inputs}/roads.csv --out {inputs}/gpudrive",
        "scenario export {inputs}/scenario.json --out {inputs}/scenario.xosc",
        "export {inputs}/session --format coco --out {inputs}/coco-1 --shard 1/2",
        "export {inputs}/session --format coco --out {inputs}/coco-2 --shard 2/2",
    ];

    public static IReadOnlyList<WritingCommand> All { get; } =
    [
        new("harvest", $"harvest --out {{root}}/out --frames 2 {Small}"),
        new("harvest-resume", $"harvest --out {{root}}/out --resume --frames 3 --no-report {Unchecked}"),
        new("harvest-town", "harvest --out {root}/out --frames 1 --size 64x48 --seed 5 --no-report") { Only = ["out/scenes/roads.csv"] },
        // Of five frames, some have their pictures drawn while others are written.
        new("harvest-queue", $"harvest --out {{root}}/out --frames 5 --no-report --no-scenes {Unchecked}") { Only = ["out/frames/"] },
        new("harvest-overwrite", $"harvest --out {{root}}/out --frames 1 --no-report --overwrite {Unchecked}", Former),
        new("harvest-shard", $"harvest --out {{root}}/out --frames 2 --shard 2/2 {Unchecked}")
        {
            Only = ["out/session.json", "out/labels.jsonl"],
            IsKilled = true,
        },
        new(
            "harvest-events",
            $"harvest --out {{root}}/out --frames 2 --resume --no-report --no-scenes --events --keep-around 1s {Unchecked}"
        )
        {
            Only = ["out/events.jsonl", "out/session.json", "out/manifest.jsonl"],
            IsKilled = true,
        },
        new("harvest-occupancy", $"harvest --out {{root}}/out --frames 1 --resume --no-report --no-scenes --occupancy {Unchecked}")
        {
            Only = ["out/occupancy"],
            IsKilled = true,
        },
        new("harvest-pairs", $"harvest --out {{root}}/out --frames 1 --resume --no-report {Pairs} {Unchecked}")
        {
            Only = ["out/pairs", "out/session.json", "out/labels.jsonl"],
            IsKilled = true,
        },
        new("plan-run", "plan run {inputs}/plan.json --out {root}/out --resume --roads {inputs}/roads.csv")
        {
            Only = ["out/plan", "out/world.json", "out/trials/."],
            IsKilled = true,
        },
        new(
            "scenario-run",
            "scenario run {inputs}/scenario.json --out {root}/out --resume --near=0,-50 --hz 1 --size 64x48 --no-report --roads "
                + "{inputs}/roads.csv"
        )
        {
            Only = ["out/scenario.json"],
            IsKilled = true,
        },
        new(
            "scenario-run-change",
            "scenario run {inputs}/scenario.json --out {root}/out --change frame_0:_weather_rain --near=0,-50 --hz 1 --size 64x48 "
                + "--no-report --roads {inputs}/roads.csv"
        )
        {
            Only = ["out/.", "out/counterfactuals.json"],
            IsKilled = true,
        },
        new("scenario-export", "scenario export {inputs}/scenario.json --out {root}/scenario.xosc"),
        new("scenario-import", "scenario import {inputs}/scenario.xosc --out {root}/scenario.json"),
        new("rebuild", "rebuild {inputs}/recipe.json --out {root}/out --input in={inputs}/session")
        {
            Only = ["out/.", "out/dataset.lock"],
            IsKilled = true,
        },
        new("pairs", "pairs {inputs}/pairs --out {root}/out --images copy --resume"),
        new("pairs-webdataset", "pairs {inputs}/pairs --out {root}/out --format webdataset --resume"),
        new("relabel", "relabel {inputs}/session --out {root}/out --resume --range 60"),
        new(
            "counterfactual",
            $"counterfactual --out {{root}}/out --frames 3 --no-report --change frame_0:_weather_rain --places 1 {Unchecked}"
        )
        {
            Only = ["out/.", "out/counterfactuals.json"],
            IsKilled = true,
        },
        new("relabel-overwrite", "relabel {inputs}/session --out {root}/out --range 60 --images copy --overwrite", Former),
        new("merge", "merge {inputs}/part-1 {inputs}/part-2 --out {root}/out --resume"),
        new("export-kitti", "export {inputs}/session --format kitti --out {root}/out"),
        new("export-kitti-flow", "export {inputs}/moving --format kitti-flow --out {root}/out"),
        new("export-occ3d", "export {inputs}/moving --format occ3d --out {root}/out"),
        new("export-euroc", "export {inputs}/moving --format euroc --out {root}/out"),
        new("export-coco", "export {inputs}/session --format coco --out {root}/out --image-format bmp"),
        new("export-coco-keypoints", "export {inputs}/people --format coco-keypoints --out {root}/out"),
        new("export-jta", "export {inputs}/people --format jta --out {root}/out"),
        new("export-webdataset", "export {inputs}/session --format webdataset --out {root}/out"),
        new("export-nuscenes", "export {inputs}/session --format nuscenes --out {root}/out"),
        new("export-openlane-v2", "export {inputs}/session --format openlane-v2 --roads {inputs}/roads.csv --out {root}/out"),
        new("export-parquet", "export {inputs}/session --format parquet --out {root}/out"),
        new("export-gpudrive", "export {inputs}/session --format gpudrive --roads {inputs}/roads.csv --out {root}/out"),
        new("export-womd", "export {inputs}/session --format womd --roads {inputs}/roads.csv --out {root}/out"),
        new("log-import", "log import {inputs}/gpudrive/train/0000_0000.json --out {root}/out"),
        new("export-motchallenge", "export {inputs}/session --format motchallenge --out {root}/out"),
        new("export-imagefolder", "export {inputs}/session --format imagefolder --out {root}/out"),
        new("export-shard", "export {inputs}/session --format yolo --out {root}/out --shard 1/2 --resume"),
        new("merge-export", "merge {inputs}/coco-1 {inputs}/coco-2 --out {root}/out --images copy --resume"),
        new(
            "merge-export-in-place",
            "merge {root}/out --out {root}/out",
            "export {inputs}/session --format csv --out {root}/out --shard 1/2",
            "export {inputs}/session --format csv --out {root}/out --shard 2/2"
        ),
        new("masks-import", "masks import {root}/out {inputs}/session/masks", $"harvest --out {{root}}/out --frames 2 {Small}"),
        new("repair", "repair {inputs}/session --out {root}/out"),
        new("report", "report {inputs}/session --out {root}/page.html", "report {inputs}/session --out {root}/page.html --frames 1"),
        new("compare", "compare {inputs}/session {inputs}/session --out {root}/compare.html"),
        new("report-still", "report {inputs}/session --still 1 --out {root}/still.png"),
        new("roads-import", "roads import {inputs}/roads.csv --out {root}/roads.csv.gz"),
        new("roads-map", "roads map {inputs}/roads.csv --size 64 --out {root}/map.png"),
        new("roads-map-lanes", "roads map {inputs}/roads.csv --out {root}/map.xodr"),
        new("roads-map-lanelet2", "roads map {inputs}/roads.csv --out {root}/map.osm"),
        new("roads-map-nuscenes", "roads map {inputs}/roads.csv --format nuscenes --out {root}/map.json"),
        new("roads-map-argoverse2", "roads map {inputs}/roads.csv --format argoverse2 --out {root}/map.json"),
        new("roads-nodes", "roads nodes {inputs}/roads.csv --out {root}/nodes.csv"),
        new("roads-photograph", "roads photograph --roads {inputs}/roads.csv --near=0,-50 --range 20 --out {root}/above")
        {
            Only = ["above/depth-completed/", "above/session.json"],
        },
        new("roads-paint", "roads paint {inputs}/lines --roads {inputs}/roads.csv --out {root}/paint.csv"),
        new("spaces-gallery", "spaces gallery {inputs}/session/scenes/spaces.csv --out {root}/gallery.html"),
        new("contact-sheet", $"{Sheet} --list {{inputs}}/places.csv", $"{Sheet} --at 0,-150"),
        new("drive", $"{Drive} --duration 2"),
        new("drive-overwrite", $"{Drive} --duration 2 --overwrite", $"{Drive} --duration 1"),
        new("drive-record", $"{Drive} --duration 1 {Record}") { Only = Recorded, IsKilled = true },
        new("drive-record-overwrite", $"{Drive} --duration 1 --overwrite {Record}", $"{Drive} --duration 0.5 {Record}")
        {
            Only = ["session."],
            IsKilled = true,
        },
        new("drive-record-starts", $"{Drive} --duration 0.4 --near 0,-50 --near 0,50 {Record}") { Only = ["session/.", "session/0002/."] },
        new("serve-record", $"serve --lockstep --once --port 0 --traffic 0 --roads {{inputs}}/roads.csv {Record}")
        {
            Only = ["session/0001/session.json"],
        },
    ];

    /// <summary>All commands, or those whose names HARVESTER_COMMANDS has, separated by spaces.</summary>
    public static IReadOnlyList<WritingCommand> Chosen =>
        Environment.GetEnvironmentVariable("HARVESTER_COMMANDS") is { Length: > 0 } names
            ? [.. names.Split(' ').Select(name => All.Single(command => command.Name == name))]
            : All;

    private static string Former => $"harvest --out {{root}}/out --frames 1 --size 80x60 --seed 6 --roads {{inputs}}/roads.csv";

    private static string Sheet => "contact-sheet --out {root}/sheet.png --roads {inputs}/roads.csv --size 64x48 --seconds 0";

    /// <summary>The files of a recording that a harvest writes otherwise, and its marks.</summary>
    private static string[] Recorded => ["session/session.json", "session/labels.jsonl", "session/."];

    private static string Record => "--record {root}/session --size 64x48";

    private static string Drive => $"drive --out {{root}}/out --traffic 0 --distance 3 --roads {{inputs}}/roads.csv";

    /// <summary>Whether a file is written when a clock says so: a sign of life, which no result depends on.</summary>
    /// <param name="path">The path below the root.</param>
    public static bool IsTimed(string path) => path.StartsWith("out/heartbeat.json", StringComparison.Ordinal);

    /// <summary>The words of a command line, in folders.</summary>
    public static string[] WordsOf(string words, string inputs, string root) =>
        [
            .. words
                .Split(' ')
                .Select(word =>
                    word.Replace("{inputs}", inputs, StringComparison.Ordinal).Replace("{root}", root, StringComparison.Ordinal)
                ),
        ];
}
