using Harvester.Cli.Commands.Tapes;
using Harvester.Datasets.Boxes;
using Harvester.Datasets.Diagnosis;
using Harvester.Datasets.Logs;
using Harvester.Datasets.Props;
using Harvester.Datasets.Recipes;
using Harvester.Datasets.Roads;
using Harvester.Exports.Formats;
using Harvester.Exports.Formats.MotionScenarios;
using Harvester.Exports.Pairs;
using Harvester.Exports.Validation;
using Harvester.Reports.Comparison;
using Harvester.Reports.Faces;
using Harvester.Runs.Plans;
using Harvester.Runs.Relabelling;
using Harvester.Runs.Scenarios;
using Harvester.Runs.Sheets;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using static Harvester.Cli.Tests.Hostile.FuzzReads;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>A kind of input file.</summary>
/// <param name="Name">Its name, which also names the folder of kept inputs.</param>
/// <param name="File">The file to damage, in the folder of the corpus.</param>
/// <param name="Read">Reads it in the test's process, from the folder of the corpus, without a command line.</param>
/// <param name="Commands">What reads it; {0} is the folder of the corpus, and output goes to {0}/out.</param>
internal sealed record FuzzKind(string Name, string File, Action<string> Read, params string[] Commands)
{
    private const string Relabel = "relabel {0}/session --no-report --out {0}/out";
    private const string Project = "project --position 0,0,0 --rotation 0,0,0 --fov 50 --size 80x60 --points {0}/points.csv";
    private const string Sheet = "contact-sheet --roads {0}/straight.csv --size 64x48 --seconds 0 --out {0}/out.png";

    private const string MapWithProps = "roads map {0}/straight.csv --props {0}/props.json --out {0}/out.xodr";
    private const string MapOfSession = "roads map {0}/straight.csv --props {0}/session --out {0}/out.geojson";

    private const string Schema = "validate {0}/session --schema --quick";
    private const string Merge = "merge {0}/shard {0}/shard2 --out {0}/out";

    /// <summary>Whether invalid lines are ignored by design, so that nothing is ever rejected.</summary>
    public bool IsReadWhatever { get; init; }

    /// <summary>All kinds.</summary>
    public static IReadOnlyList<FuzzKind> All { get; } =
    [
        new(
            "session",
            "session/session.json",
            ValidateSession,
            "validate {0}/session",
            "stats {0}/session",
            "report {0}/session",
            Relabel,
            Export("csv"),
            "doctor {0}/session",
            Schema
        ),
        new(
            "labels",
            "session/labels.jsonl",
            ReadLabels,
            [
                "validate {0}/session",
                Schema,
                "stats {0}/session",
                "report {0}/session --out {0}/out.html",
                "report {0}/session --still 0 --out " + "{0}/out.png",
                "compare {0}/session {0}/session --out {0}/out.html",
                Relabel,
                "masks import {0}/session {0}/maps",
                "roads paint {0}/session --out {0}/out.csv",
                MapOfSession,
                "pairs {0}/session --format csv --out {0}/out",
                .. DatasetFormats.All.Where(format => format.Program is null).Select(format => Export(format.Name)),
            ]
        ),
        new(
            "joints",
            "people/labels.jsonl",
            ReadPeople,
            "validate {0}/people",
            "stats {0}/people",
            "report {0}/people --out {0}/out.html",
            "relabel {0}/people --no-report --out {0}/out",
            "export {0}/people --format coco-keypoints --out {0}/out",
            "export {0}/people --format jta --out {0}/out"
        ),
        new(
            "manifest",
            "session/manifest.jsonl",
            ValidateSession,
            "validate {0}/session",
            Relabel,
            "repair {0}/session --out {0}/out",
            "masks import {0}/session {0}/maps",
            Export("csv")
        ),
        new(
            "events",
            "eventful/events.jsonl",
            ReadEvents,
            "validate {0}/eventful",
            "validate {0}/eventful --schema --quick",
            "stats {0}/eventful",
            "repair {0}/eventful --out {0}/out"
        ),
        new("scene", "session/scenes/00000000.json", ValidateSession, "validate {0}/session", Relabel, MapOfSession),
        Roads("roads", "session/scenes/roads.csv", "validate {0}/session", Relabel) with
        {
            Read = ReadRoadsOfSession,
        },
        Roads("ipl", "paths.ipl"),
        Roads("paths-xml", "paths.xml"),
        Roads("ynd", "nodes.ynd.xml"),
        Roads("road-dump", "nodes.json"),
        new(
            "faces",
            "session/scenes/spaces.csv",
            folder => ReadFaces(In(folder, "session/scenes/spaces.csv")),
            "validate {0}/session",
            "spaces check {0}/session/scenes/spaces.csv",
            "spaces list {0}/session/scenes/spaces.csv",
            "spaces gallery {0}/session/scenes/spaces.csv --out {0}/out.html"
        ),
        Picture("png", "session", "png", "export {0}/session --format csv --image-format bmp --out {0}/out", Export("deepdriving")),
        new("mask", "session/masks/00000000.png", ValidatePictures, "validate {0}/session", Export("coco"), Export("cityscapes"), Relabel),
        new("class-map", "session/classes/00000000.png", ValidatePictures, "validate {0}/session", Export("semantic")),
        .. FrameChannels
            .All.OfType<MapChannel>()
            .Select(channel => new FuzzKind(
                channel.Key,
                $"session/{channel.PathOf(0, null)}",
                ValidatePictures,
                "validate {0}/session",
                Relabel
            )),
        new("depth", "session/depth/00000000.png", ValidatePictures, "validate {0}/session", Relabel),
        new("flow", "session/flow-forward/00000001.png", ValidatePictures, "validate {0}/session", Relabel, Export("kitti-flow")),
        new(
            "flow-flags",
            "session/flow-forward-flags/00000001.png",
            ValidatePictures,
            "validate {0}/session",
            Relabel,
            Export("middlebury-flow")
        ),
        new(
            "occupancy",
            "session/occupancy/00000000.png",
            ValidatePictures,
            "validate {0}/session",
            Relabel,
            Export("occ3d"),
            Export("mcap")
        ),
        new(
            "occupancy-instances",
            "session/occupancy-instances/00000000.png",
            ValidatePictures,
            "validate {0}/session",
            Export("occ3d"),
            Export("mcap")
        ),
        new("occupancy-visible", "session/occupancy-visible/00000000.png", ValidatePictures, "validate {0}/session", Export("occ3d")),
        new("birds-eye", "session/birds-eye/00000000.png", ValidatePictures, "validate {0}/session", Relabel, Export("mcap")),
        new("birds-eye-visible", "session/birds-eye-visible/00000000.png", ValidatePictures, "validate {0}/session", Export("mcap")),
        new(
            "map",
            "maps/0.png",
            folder => PngDecoder.ReadInstanceMap(In(folder, "maps/0.png")),
            "masks import {0}/session {0}/maps",
            "masks import {0}/session {0}/maps --match"
        ),
        Picture("jpg", "jpg", "jpg"),
        Picture("bmp", "bmp", "bmp"),
        Dataset("export", "csv", "export.json"),
        Dataset("dataset-manifest", "csv", "manifest.jsonl"),
        Dataset("csv-frames", "csv", "frames.csv"),
        Dataset("csv-objects", "csv", "objects.csv"),
        Dataset("parquet-frames", "parquet", "frames.parquet"),
        Dataset("parquet-objects", "parquet", "objects.parquet"),
        Dataset("coco", "coco", "annotations/instances_train.json"),
        Dataset("panoptic", "coco-panoptic", "annotations/panoptic_train.json"),
        Dataset("keypoints", "coco-keypoints", "annotations/person_keypoints_train.json"),
        Dataset("jta", "jta", "annotations/train/seq_0.json"),
        Dataset("jta-camera", "jta", "cameras/train/seq_0.json"),
        Dataset("kitti", "kitti", "training/label_2/000000.txt"),
        Dataset("kitti-tracking", "kitti-tracking", "training/label_02/0000.txt"),
        Dataset("kitti-flow", "kitti-flow", "training/flow_occ/000001_10.png"),
        Dataset("middlebury-flow", "middlebury-flow", "other-gt-flow/000001/flow10.flo"),
        Dataset("euroc", "euroc", "train/0000/mav0/imu0/data.csv"),
        Dataset("euroc-states", "euroc", "train/0000/mav0/state_groundtruth_estimate0/data.csv"),
        Dataset("euroc-gnss", "euroc", "train/0000/mav0/gnss0/data.csv"),
        Dataset("voc", "voc", "Annotations/00000000.xml"),
        Dataset("yolo", "yolo", "labels/train/00000000.txt"),
        Dataset("outlines", "yolo-segment", "labels/train/00000000.txt"),
        Dataset("cityscapes", "cityscapes", "gtFine/train/session0000/session0000_000000_000000_gtFine_polygons.json"),
        Dataset("semantic", "semantic", "classes.json"),
        Dataset("indicators", "deepdriving", "indicators.csv"),
        Dataset("tusimple", "tusimple", "label_data_train.json"),
        Dataset("openlane", "openlane", "lane3d/train/segment-0000/00000000.json"),
        Dataset("openlane-v2", "openlane-v2", "data_dict_gta.json"),
        Dataset("gpudrive", "gpudrive", "train/0000_0000.json"),
        Dataset("gpudrive-frames", "gpudrive", "frames.csv"),
        Dataset("womd", "womd", "train.tfrecord-00000-of-00001"),
        Dataset("womd-scenarios", "womd", "scenarios.csv"),
        Dataset("webdataset", "webdataset", "train-000000.tar"),
        Dataset("mcap", "mcap", "train/0000.mcap"),
        Dataset("bdd100k", "bdd100k", "labels/det_20/det_train.json"),
        Dataset("bdd100k-lanes", "bdd100k", "labels/lane/polygons/lane_train.json"),
        Dataset("motchallenge", "motchallenge", "MOT17-train/sequence-0000/gt/gt.txt"),
        Dataset("motchallenge-sequence", "motchallenge", "MOT17-train/sequence-0000/seqinfo.ini"),
        Dataset("openlabel", "openlabel", "labels/train/0000.json"),
        Dataset("nuscenes", "nuscenes", "v1.0-gta/sample_data.json"),
        Dataset("nuscenes-splits", "nuscenes", "v1.0-gta/splits.json"),
        Dataset("nuscenes-can-bus", "nuscenes", "can_bus/scene-2001_pose.json"),
        Dataset("occ3d", "occ3d", "annotations.json"),
        Dataset("occ3d-voxels", "occ3d", "gts/scene-2001/ae733fc029229053159314d6ed7675fd/labels.npz"),
        Dataset("odometry", "kitti-odometry", "poses/00.txt"),
        Dataset("odometry-calibration", "kitti-odometry", "sequences/00/calib.txt"),
        Dataset("clouds", "ply", "clouds.csv"),
        Dataset("pcd", "pcd", "clouds.csv"),
        Dataset("culane", "culane", "list/train.txt"),
        Dataset("culane-truth", "culane", "list/train_gt.txt"),
        Dataset("imagefolder", "imagefolder", "data/train/metadata.jsonl"),
        new(
            "experiment",
            "plan.json",
            folder => PlanFile.Read(In(folder, "plan.json")),
            "plan check {0}/plan.json",
            "plan show {0}/plan.json",
            "plan resolve {0}/plan.json --out {0}/out.json"
        ),
        new(
            "recipe",
            "recipe.json",
            folder => DatasetRecipe.Read(In(folder, "recipe.json")),
            "rebuild {0}/recipe.json --check --out {0}/out --input more={0}/straight.csv"
        ),
        new("counterfactuals", "set/counterfactuals.json", folder => ChangeSet.Read(In(folder, "set")), "pairs {0}/set --out {0}/out"),
        new(
            "scenario",
            "scenario.json",
            folder => PlanFile.Read(In(folder, "staged.json")),
            "scenario check {0}/scenario.json",
            "scenario show {0}/scenario.json",
            "scenario export {0}/scenario.json --out {0}/out.xosc",
            "plan check {0}/staged.json"
        ),
        new(
            "open-scenario",
            "scenario.xosc",
            folder => OpenScenarioReader.Read(InputFile.ReadAllText(In(folder, "scenario.xosc")), "fuzz"),
            "scenario import {0}/scenario.xosc --out {0}/out.json"
        ),
        new("experiment-rig", "rig.json", folder => PlanFile.Read(In(folder, "plan.json")), "plan check {0}/plan.json"),
        Compared("kitti-compared", "kitti/training/label_2/000000.txt", ComparedKitti.Open, "--kitti {0}/kitti"),
        Compared("nuscenes-compared", "nuscenes/v1.0-gta/sample_annotation.json", ComparedNuScenes.Open, "--nuscenes {0}/nuscenes"),
        Compared("calibration-compared", "nuscenes/v1.0-gta/calibrated_sensor.json", ComparedNuScenes.Open, "--nuscenes {0}/nuscenes"),
        new("plan", "shard/.export/plan.json", MergeShards, Merge, "validate {0}/shard"),
        new("journal", "shard/.export/journal-1-of-2.jsonl", MergeShards, Merge),
        new("points", "points.csv", ReadPoints, Project),
        new(
            "vehicles",
            "vehicles.csv",
            ReadVehicles,
            "lanes --roads {0}/session/scenes/roads.csv --position 0,0,0 --heading 0 --vehicles " + "{0}/vehicles.csv"
        ),
        new(
            "paint",
            "paint.csv",
            folder => PaintFile.Read(In(folder, "paint.csv"), RoadImporter.Import(In(folder, "straight.csv")).Network),
            "lanes --roads {0}/straight.csv --paint {0}/paint.csv --position 2,-100,30 --heading 0",
            "roads map {0}/straight.csv --paint {0}/paint.csv --out {0}/out.xodr",
            "relabel {0}/people --roads {0}/straight.csv --paint {0}/paint.csv --no-report --out {0}/out",
            "harvest --roads {0}/straight.csv --paint {0}/paint.csv --frames 1 --size 64x48 --no-report --out {0}/out",
            "drive --roads {0}/straight.csv --paint {0}/paint.csv --distance 1 --out {0}/out"
        ),
        new(
            "log-gpudrive",
            "gpudrive/train/0000_0000.json",
            folder => GpuDriveReader.Read(In(folder, "gpudrive/train/0000_0000.json")),
            "log import {0}/gpudrive/train/0000_0000.json --out {0}/out"
        ),
        new(
            "log-womd",
            "womd/train.tfrecord-00000-of-00001",
            folder => WomdReader.Read(In(folder, "womd/train.tfrecord-00000-of-00001")).ToList(),
            "log import {0}/womd/train.tfrecord-00000-of-00001 --out {0}/out"
        ),
        new(
            "traffic",
            "logs/0000/traffic.json",
            folder => TrafficFile.Read(In(folder, "logs/0000/traffic.json")),
            "harvest --log {0}/logs/0000 --frames 1 --size 64x48 --no-report --out {0}/out"
        ),
        new("places", "places.csv", folder => PlaceList.Read(In(folder, "places.csv")), $"{Sheet} --list {{0}}/places.csv"),
        new(
            "props",
            "props.json",
            folder => PropPlacementImporter.Import(In(folder, "props.json")),
            $"{Sheet} --props {{0}}/props.json",
            MapWithProps
        ),
        new("lens", "lens.txt", folder => LensFile.Read(In(folder, "lens.txt")), $"{Project} --calibration {{0}}/lens.txt"),
        new("boxes", "boxes.json", folder => BoxSceneReader.Read(new FileInfo(In(folder, "boxes.json"))), "boxes {0}/boxes.json"),
        new("log", "GtaDataHarvester.log", folder => Doctor.Examine(In(folder, "GtaDataHarvester.log")), "doctor {0}/GtaDataHarvester.log"),
        new("self-test", "selftest.json", folder => Doctor.Examine(In(folder, "selftest.json")), "doctor {0}/selftest.json"),
        new("tape", "a.tape", folder => TapePlayCommand.Play(In(folder, "a.tape"), CancellationToken.None), "tape play {0}/a.tape"),
        new(
            "photos",
            "survey/photos.csv",
            folder => new FaceGallery(ReadFaces(In(folder, "survey/spaces.csv")), In(folder, "survey")).Write(Stream.Null),
            "spaces gallery {0}/survey --out {0}/out.html"
        )
        {
            IsReadWhatever = true,
        },
    ];

    /// <summary>All names, as cases of a theory.</summary>
    public static TheoryData<string> Names => [.. All.Select(kind => kind.Name)];

    /// <summary>The kind of a name.</summary>
    public static FuzzKind Of(string name) => All.Single(kind => kind.Name == name);

    /// <summary>What is against the promise in reading; null for nothing.</summary>
    public string? FaultOf(string folder)
    {
        try
        {
            Read(folder);
            return null;
        }
        catch (Exception e) when (e is DatasetFormatException or IOException or UnauthorizedAccessException)
        {
            return e.Message.Length > 0 ? null : $"{e.GetType().Name} without a message";
        }
        catch (Exception e)
        {
            return $"{e.GetType().Name}: {e.Message} {e.StackTrace?.Split('\n')[0].Trim()}";
        }
    }

    private static FuzzKind Dataset(string name, string dataset, string file) =>
        new(name, $"{dataset}/{file}", folder => DatasetValidator.Validate(In(folder, dataset)), $"validate {{0}}/{dataset}");

    private static FuzzKind Compared(string name, string file, Func<string, IComparedDataset> open, string other) =>
        new(
            name,
            file,
            folder => open(In(folder, file.Split('/')[0])).Read(static _ => { }, CancellationToken.None),
            $"compare {{0}}/session {other} --out {{0}}/out.html"
        );

    private static FuzzKind Roads(string name, string file, params string[] more) =>
        new(
            name,
            file,
            folder => RoadImporter.Import(In(folder, file)),
            [
                $"roads info {{0}}/{file}",
                $"roads map {{0}}/{file} --out {{0}}/out.svg",
                $"roads map {{0}}/{file} --out {{0}}/out.xodr",
                $"roads map {{0}}/{file} --out {{0}}/out.osm",
                $"roads map {{0}}/{file} --format nuscenes --out {{0}}/out.json",
                $"roads map {{0}}/{file} --format argoverse2 --out {{0}}/map.json",
                $"roads import {{0}}/{file} --out {{0}}/out.csv",
                $"roads nodes {{0}}/{file} --out {{0}}/out.csv",
                $"roads compare {{0}}/{file} {{0}}/straight.csv",
                $"roads photograph --roads {{0}}/{file} --range 10 --out {{0}}/out",
                .. more,
            ]
        );

    private static FuzzKind Picture(string name, string session, string extension, params string[] more)
    {
        string file = $"{session}/frames/00000000.{extension}";
        return new FuzzKind(
            name,
            file,
            folder => PictureReader.Read(In(folder, file)),
            [$"validate {{0}}/{session}", $"report {{0}}/{session} --still 0 --out {{0}}/out.png", .. more]
        );
    }

    private static string Export(string format) => $"export {{0}}/session --format {format} --out {{0}}/out";
}
