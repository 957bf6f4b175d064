namespace Harvester.Datasets.Exports.Formats.Mcap;

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

    public static McapChannel Indicators { get; } = new(7, "/indicators", IndicatorMessage.SchemaName);

    /// <summary>All channels, by number.</summary>
    public static McapChannel[] All { get; } = [Image, Calibration, Transforms, Objects, Lanes, Annotations, Indicators];
}
