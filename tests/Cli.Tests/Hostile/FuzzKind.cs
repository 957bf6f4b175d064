namespace Harvester.Cli.Tests.Hostile;

/// <summary>A kind of input file.</summary>
/// <param name="Name">Its name, which also names the folder of kept inputs.</param>
/// <param name="File">The file to damage, in the folder of the corpus.</param>
/// <param name="Commands">What reads it; {0} is the folder of the corpus, and output goes to {0}/out.</param>
internal sealed record FuzzKind(string Name, string File, params string[] Commands)
{
    private const string Relabel = "relabel {0}/session --no-report --out {0}/out";

    /// <summary>Whether invalid lines are ignored by design, so that nothing is ever rejected.</summary>
    public bool IsReadWhatever { get; init; }

    /// <summary>All kinds.</summary>
    public static IReadOnlyList<FuzzKind> All { get; } =
    [
        new("session", "session/session.json", "validate {0}/session", "stats {0}/session", "report {0}/session", Relabel,
            Export("csv"), "doctor {0}/session"),
        new("labels", "session/labels.jsonl", [
            "validate {0}/session", "stats {0}/session", "report {0}/session --out {0}/out.html", "report {0}/session --still 0 --out "
                + "{0}/out.png", Relabel, "masks import {0}/session {0}/maps",
            .. "csv coco coco-panoptic yolo kitti kitti-tracking voc cityscapes webdataset openlane tusimple deepdriving".Split(' ')
                .Select(Export),
        ]),
        new("scene", "session/scenes/00000000.json", "validate {0}/session", Relabel),
        new("roads", "session/scenes/roads.csv", "validate {0}/session",
            Relabel, "roads info {0}/session/scenes/roads.csv", "roads map {0}/session/scenes/roads.csv --out {0}/out.svg"),
        new("faces", "session/scenes/spaces.csv", "validate {0}/session", "spaces check {0}/session/scenes/spaces.csv",
            "spaces list {0}/session/scenes/spaces.csv", "spaces gallery {0}/session/scenes/spaces.csv --out {0}/out.html"),
        new("png", "session/frames/00000000.png", "validate {0}/session", "report {0}/session --still 0 --out {0}/out.png",
            "export {0}/session --format csv --image-format bmp --out {0}/out", Export("deepdriving")),
        new("mask", "session/masks/00000000.png", "validate {0}/session", Export("coco"), Export("cityscapes"), Relabel),
        new("map", "maps/0.png", "masks import {0}/session {0}/maps", "masks import {0}/session {0}/maps --match"),
        new("jpg", "jpg/frames/00000000.jpg", "validate {0}/jpg", "report {0}/jpg --still 0 --out {0}/out.png"),
        new("bmp", "bmp/frames/00000000.bmp", "validate {0}/bmp", "report {0}/bmp --still 0 --out {0}/out.png"),
        new("manifest", "csv/export.json", "validate {0}/csv"),
        new("csv-frames", "csv/frames.csv", "validate {0}/csv"),
        new("csv-objects", "csv/objects.csv", "validate {0}/csv"),
        new("coco", "coco/annotations/instances_train.json", "validate {0}/coco"),
        new("panoptic", "coco-panoptic/annotations/panoptic_train.json", "validate {0}/coco-panoptic"),
        new("kitti", "kitti/training/label_2/000000.txt", "validate {0}/kitti"),
        new("voc", "voc/Annotations/00000000.xml", "validate {0}/voc"),
        new("yolo", "yolo/labels/train/00000000.txt", "validate {0}/yolo"),
        new("webdataset", "webdataset/train-000000.tar", "validate {0}/webdataset"),
        new("plan", "shard/.export/plan.json", "merge {0}/shard {0}/shard2 --out {0}/out", "validate {0}/shard"),
        new("journal", "shard/.export/journal-1-of-2.jsonl", "merge {0}/shard {0}/shard2 --out {0}/out"),
        new("points", "points.csv", "project --position 0,0,0 --rotation 0,0,0 --fov 50 --size 80x60 --points {0}/points.csv"),
        new("vehicles", "vehicles.csv", "lanes --roads {0}/session/scenes/roads.csv --position 0,0,0 --heading 0 --vehicles "
            + "{0}/vehicles.csv"),
        new("lens", "lens.txt", "project --position 0,0,0 --rotation 0,0,0 --fov 50 --size 80x60 --points {0}/points.csv --calibration "
            + "{0}/lens.txt"),
        new("boxes", "boxes.json", "boxes {0}/boxes.json"),
        new("log", "GtaDataHarvester.log", "doctor {0}/GtaDataHarvester.log"),
        new("photos", "survey/photos.csv", "spaces gallery {0}/survey --out {0}/out.html") { IsReadWhatever = true },
    ];

    private static string Export(string format) => $"export {{0}}/session --format {format} --out {{0}}/out";
}
