using Harvester.Exports.Formats.Bdd100K;
using Harvester.Exports.Formats.Cityscapes;
using Harvester.Exports.Formats.Coco;
using Harvester.Exports.Formats.Columns;
using Harvester.Exports.Formats.Csv;
using Harvester.Exports.Formats.DeepDriving;
using Harvester.Exports.Formats.Euroc;
using Harvester.Exports.Formats.Flow;
using Harvester.Exports.Formats.ImageFolder;
using Harvester.Exports.Formats.Jta;
using Harvester.Exports.Formats.Kitti;
using Harvester.Exports.Formats.Lanes;
using Harvester.Exports.Formats.Mcap;
using Harvester.Exports.Formats.MotChallenge;
using Harvester.Exports.Formats.MotionScenarios;
using Harvester.Exports.Formats.NuScenes;
using Harvester.Exports.Formats.Occ3d;
using Harvester.Exports.Formats.OpenLabel;
using Harvester.Exports.Formats.OpenLaneV2;
using Harvester.Exports.Formats.PointClouds;
using Harvester.Exports.Formats.Semantic;
using Harvester.Exports.Formats.Video;
using Harvester.Exports.Formats.Voc;
using Harvester.Exports.Formats.WebDataset;
using Harvester.Exports.Formats.Yolo;

namespace Harvester.Exports.Formats;

/// <summary>The formats that can be exported; each has a page in docs/exports.</summary>
public static class DatasetFormats
{
    /// <summary>All formats, in the order of the help.</summary>
    public static IReadOnlyList<DatasetFormat> All { get; } =
    [
        new("kitti", "KITTI object detection: images, label_2, calib, velodyne, oxts", options => new KittiWriter(options))
        {
            NeedsRectilinear = true,
            UsesMasks = true,
            HasBoxes = true,
            HasNames = true,
            Names = KittiClasses.Types,
            IncludesRiders = true,
            HasPoints = true,
            Check = KittiCheck.Problems,
        },
        new("kitti-tracking", "KITTI tracking: a sequence for each place", options => new KittiTrackingWriter(options))
        {
            NeedsRectilinear = true,
            UsesMasks = true,
            HasBoxes = true,
            HasNames = true,
            Names = KittiClasses.Types,
            KeepsSequences = true,
            IncludesRiders = true,
            Check = KittiTrackingCheck.Problems,
        },
        new("kitti-odometry", "KITTI odometry: images, points, poses and SemanticKITTI's labels", _ => new KittiOdometryWriter())
        {
            NeedsRectilinear = true,
            KeepsSequences = true,
            ListsObjects = false,
            HasPoints = true,
            Check = KittiOdometryCheck.Problems,
        },
        new("kitti-flow", "KITTI 2015 optical flow: pairs of images", _ => new FlowWriter(FlowLayout.Kitti))
        {
            ListsObjects = false,
            NeedsFlow = true,
            Check = FlowExportCheck.KittiProblems,
        },
        new("middlebury-flow", "Middlebury optical flow: pairs of images and .flo", _ => new FlowWriter(FlowLayout.Middlebury))
        {
            ListsObjects = false,
            NeedsFlow = true,
            Check = FlowExportCheck.MiddleburyProblems,
        },
        new("euroc", "EuRoC visual-inertial sequences: images, samples of the inertial unit, states", _ => new EurocWriter())
        {
            ListsObjects = false,
            NeedsImu = true,
            KeepsSequences = true,
            Check = EurocCheck.Problems,
        },
        new("coco", "COCO instances", options => new CocoWriter(options))
        {
            UsesMasks = true,
            HasBoxes = true,
            HasBoxesBeyondImage = true,
            HasNames = true,
            HasSubclasses = true,
            HasParts = true,
            HasSegmentations = true,
            Check = CocoCheck.Problems,
        },
        new("coco-panoptic", "COCO panoptic segmentation", options => new CocoPanopticWriter(options))
        {
            NeedsMasks = true,
            UsesClassMaps = true,
            HasNames = true,
            HasSubclasses = true,
            HasParts = true,
            HasPoles = true,
            Check = CocoPanopticCheck.Problems,
        },
        new("coco-keypoints", "COCO keypoints of people", options => new CocoKeypointsWriter(options))
        {
            UsesMasks = true,
            Check = CocoKeypointsCheck.Problems,
        },
        new("jta", "JTA's layout of joints: a sequence for each place", _ => new JtaWriter())
        {
            NeedsRectilinear = true,
            KeepsSequences = true,
            Check = JtaCheck.Problems,
        },
        new("yolo", "Ultralytics YOLO, boxes", options => new YoloWriter(options))
        {
            UsesMasks = true,
            HasBoxes = true,
            HasNames = true,
            HasSubclasses = true,
            HasParts = true,
            Check = YoloCheck.BoxProblems,
        },
        new("yolo-segment", "Ultralytics YOLO, outlines", options => new YoloSegmentWriter(options))
        {
            NeedsMasks = true,
            HasNames = true,
            HasSubclasses = true,
            HasParts = true,
            Check = YoloCheck.OutlineProblems,
        },
        new("voc", "Pascal VOC", options => new VocWriter(options))
        {
            UsesMasks = true,
            HasBoxes = true,
            HasNames = true,
            HasSubclasses = true,
            HasParts = true,
            Check = VocCheck.Problems,
        },
        new("cityscapes", "Maps of instances and classes in the style of Cityscapes", options => new CityscapesWriter(options))
        {
            NeedsMasks = true,
            UsesClassMaps = true,
            HasNames = true,
            Names = CityscapesLabels.ObjectNames,
            HasParts = true,
            HasPoles = true,
            Check = CityscapesCheck.Problems,
        },
        new("semantic", "Class maps with a palette, and the drivable area", _ => new SemanticWriter())
        {
            NeedsClassMaps = true,
            Check = SemanticCheck.Problems,
        },
        new("bdd100k", "BDD100K detection, tracking and lane markings", options => new Bdd100KWriter(options))
        {
            UsesMasks = true,
            HasBoxes = true,
            HasNames = true,
            Names = Bdd100KClasses.Names,
            HasParts = true,
            Check = Bdd100KCheck.Problems,
        },
        new("motchallenge", "MOTChallenge: a sequence for each place, with MOT17's classes", _ => new MotWriter())
        {
            UsesMasks = true,
            HasBoxes = true,
            HasBoxesBeyondImage = true,
            KeepsSequences = true,
            Check = MotCheck.Problems,
        },
        new("openlabel", "ASAM OpenLABEL 1.0: a file for each place", _ => new OpenLabelWriter())
        {
            UsesMasks = true,
            HasBoxes = true,
            HasBoxesBeyondImage = true,
            HasNames = true,
            HasParts = true,
            KeepsSequences = true,
            Check = OpenLabelCheck.Problems,
        },
        new("nuscenes", "nuScenes: the tables, samples and sweeps of a rig", _ => new NuScenesWriter())
        {
            NeedsRectilinear = true,
            KeepsSequences = true,
            MinRateHz = NuScenesWriter.MinRateHz,
            HasPoints = true,
            IncludesRiders = true,
            Check = NuScenesCheck.Problems,
        },
        new("occ3d", "Occ3D-nuScenes: voxels around the vehicle with classes, and images", _ => new Occ3dWriter())
        {
            NeedsRectilinear = true,
            NeedsOccupancy = true,
            KeepsSequences = true,
            ListsObjects = false,
            Check = Occ3dCheck.Problems,
        },
        Points("pcd", "Point clouds of LiDARs, as PCL's PCD files", PointCloudKind.Pcd),
        Points("ply", "Point clouds of LiDARs, as PLY files", PointCloudKind.Ply),
        new("deepdriving", "Images of 280 x 210 and DeepDriving's thirteen indicators", options => new DeepDrivingWriter(options))
        {
            NeedsLanes = true,
            KeepsImages = false,
            Check = DeepDrivingCheck.Problems,
        },
        new("tusimple", "TuSimple lanes", options => new TuSimpleWriter(options))
        {
            NeedsLanes = true,
            LeavesOutUnknownLanes = true,
            HasLaneSelection = true,
            Check = TuSimpleCheck.Problems,
        },
        new("culane", "CULane lanes", options => new CuLaneWriter(options))
        {
            NeedsLanes = true,
            LeavesOutUnknownLanes = true,
            Check = CuLaneCheck.Problems,
            SplitNames = CuLaneWriter.ListsOf,
        },
        new("openlane", "OpenLane 3D lane lines", _ => new OpenLaneWriter())
        {
            NeedsLanes = true,
            LeavesOutUnknownLanes = true,
            Check = OpenLaneCheck.Problems,
        },
        new("openlane-v2", "OpenLane-V2: lanes, traffic elements and their topology", options => new OpenLaneV2Writer(options))
        {
            NeedsLanes = true,
            HasMap = true,
            NeedsRectilinear = true,
            KeepsSequences = true,
            Check = OpenLaneV2Check.Problems,
        },
        Motion("gpudrive", "GPUDrive: what moves and the map, a file for each 9 s", isWomd: false),
        Motion("womd", "Waymo Open Motion Dataset: the same as Scenario messages", isWomd: true),
        new("webdataset", "Tar archives for streaming readers", _ => new WebDatasetWriter())
        {
            UsesMasks = true,
            KeepsUndetermined = true,
            HasParts = true,
            DefaultParts = PartSelection.All,
            KeepsImages = false,
            Check = WebDatasetCheck.Problems,
            Card = new("webdataset", WebDatasetWriter.ArchivesOf),
        },
        new("imagefolder", "Folders of images with metadata.jsonl, as Hugging Face reads them", options => new ImageFolderWriter(options))
        {
            UsesMasks = true,
            HasBoxes = true,
            HasNames = true,
            HasSubclasses = true,
            HasParts = true,
            Check = ImageFolderCheck.Problems,
            Card = new("imagefolder", split => $"data/{split}/**"),
        },
        new("mcap", "MCAP recordings with Foxglove's messages: a file for each place", _ => new McapWriter())
        {
            HasPoints = true,
            UsesMasks = true,
            HasBoxes = true,
            HasBoxesBeyondImage = true,
            HasParts = true,
            KeepsImages = false,
            KeepsSequences = true,
            Check = McapCheck.Problems,
        },
        new("csv", "Flat tables of frames and objects", options => new CsvDatasetWriter(options))
        {
            KeepsUndetermined = true,
            HasNames = true,
            HasParts = true,
            DefaultParts = PartSelection.All,
            Check = CsvDatasetCheck.Problems,
        },
        new("parquet", "Typed tables of all labels, as columns", options => new ParquetDatasetWriter(options))
        {
            KeepsUndetermined = true,
            HasNames = true,
            HasParts = true,
            DefaultParts = PartSelection.All,
            Check = ParquetDatasetCheck.Problems,
        },
        Video("video", "A video for each place, H.264 in MP4; masks and depth lossless", isLossless: false),
        Video("video-lossless", "The same, FFV1 in Matroska", isLossless: true),
    ];

    /// <summary>The format of a name; null if there is none.</summary>
    public static DatasetFormat? Find(string name) =>
        All.FirstOrDefault(format => string.Equals(format.Name, name, StringComparison.OrdinalIgnoreCase));

    private static DatasetFormat Motion(string name, string description, bool isWomd) =>
        new(name, description, options => new MotionScenarioWriter(options, isWomd))
        {
            HasMap = true,
            KeepsImages = false,
            KeepsSequences = true,
            ListsObjects = false,
            MinRateHz = MotionScenarioWriter.MinRateHz,
            Check = isWomd ? MotionScenarioCheck.WomdProblems : MotionScenarioCheck.GpuDriveProblems,
        };

    private static DatasetFormat Points(string name, string description, PointCloudKind kind) =>
        new(name, description, _ => new PointCloudWriter(kind))
        {
            ListsObjects = false,
            KeepsImages = false,
            KeepsSequences = true,
            HasPoints = true,
            Check = dataset => PointCloudCheck.Problems(dataset, kind),
        };

    private static DatasetFormat Video(string name, string description, bool isLossless) =>
        new(name, description, _ => new VideoWriter(isLossless))
        {
            Program = FfmpegProgram.Name,
            UsesMasks = true,
            KeepsSequences = true,
            ListsObjects = false,
            Check = dataset => VideoCheck.Problems(dataset, isLossless),
        };
}
