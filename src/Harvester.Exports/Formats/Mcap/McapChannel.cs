namespace Harvester.Exports.Formats.Mcap;

/// <summary>A channel of an MCAP file.</summary>
/// <param name="Id">Its number, from 1; that of its schema is the number of the schema in the file.</param>
/// <param name="Topic">Its name.</param>
/// <param name="Schema">Full name of the protobuf message.</param>
internal sealed record McapChannel(int Id, string Topic, string Schema)
{
    public static McapChannel Image { get; } = new(1, "/camera/image", "foxglove.CompressedImage");

    public static McapChannel Calibration { get; } = new(2, "/camera/calibration", "foxglove.CameraCalibration");

    public static McapChannel Transforms { get; } = new(3, "/tf", "foxglove.FrameTransforms");

    public static McapChannel Objects { get; } = new(4, "/objects", "foxglove.SceneUpdate");

    public static McapChannel Lanes { get; } = new(5, "/lanes", "foxglove.SceneUpdate");

    public static McapChannel Annotations { get; } = new(6, "/camera/annotations", "foxglove.ImageAnnotations");

    public static McapChannel Indicators { get; } = new(7, "/indicators", "gtaharvest.LaneIndicators");

    public static McapChannel Action { get; } = new(8, "/drive/action", "gtaharvest.DriveAction");

    public static McapChannel AnsweredIndicators { get; } = new(9, "/drive/indicators", "gtaharvest.LaneIndicators");

    public static McapChannel Tick { get; } = new(10, "/drive/tick", "gtaharvest.DriveTick");

    public static McapChannel Imu { get; } = new(11, "/imu", "gtaharvest.Imu");

    public static McapChannel Events { get; } = new(12, "/events", "gtaharvest.OpenEvents");

    public static McapChannel BirdsEye { get; } = new(13, "/birds_eye", "foxglove.Grid");

    public static McapChannel Depth { get; } = new(14, "/camera/depth", "foxglove.RawImage");

    public static McapChannel Occupancy { get; } = new(15, "/occupancy", "foxglove.VoxelGrid");

    /// <summary>The channels of every file of a single camera, by number.</summary>
    public static McapChannel[] OfSessions { get; } = [Image, Calibration, Transforms, Objects, Lanes, Annotations, Indicators];

    /// <summary>The further channels of a file with a recorded drive, by number.</summary>
    public static McapChannel[] OfDrives { get; } = [Action, AnsweredIndicators, Tick, Imu];

    /// <summary>The further channels of a file with events.</summary>
    public static McapChannel[] OfEvents { get; } = [Events];

    /// <summary>The further channels of a file with bird's-eye maps.</summary>
    public static McapChannel[] OfGrids { get; } = [BirdsEye];

    /// <summary>The further channel of a file with depth maps.</summary>
    public static McapChannel[] OfDepths { get; } = [Depth];

    /// <summary>The further channel of a file with voxels.</summary>
    public static McapChannel[] OfVoxels { get; } = [Occupancy];

    /// <summary>The channels that only some files have, by number; a file has them from their first message on.</summary>
    public static McapChannel[][] OfSome { get; } = [OfDrives, OfEvents, OfGrids, OfDepths, OfVoxels];

    /// <summary>All channels of files of a single camera, by number. Those of rigs follow from the rig.</summary>
    public static McapChannel[] All { get; } = [.. OfSessions, .. OfSome.SelectMany(some => some)];
}
