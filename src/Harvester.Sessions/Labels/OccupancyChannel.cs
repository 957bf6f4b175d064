using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of voxels: greyscale PNG images of the layers of a box around the ego, one below the other.</summary>
public sealed class OccupancyChannel : FrameChannel
{
    /// <summary>Folder of the maps of classes.</summary>
    public const string MapFolder = "occupancy";

    /// <summary>Folder of the maps of objects.</summary>
    public const string InstanceFolder = "occupancy-instances";

    /// <summary>Folder of the maps of visible voxels.</summary>
    public const string VisibleFolder = "occupancy-visible";

    private const int BitsOfClasses = 8;
    private const int BitsOfInstances = 16;
    private const int Axes = 3;

    /// <inheritdoc />
    public override string Key => "occupancy";

    /// <inheritdoc />
    public override string FileKind => "map of voxels";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [MapFolder, InstanceFolder, VisibleFolder];

    /// <inheritdoc />
    public override ChannelSwitch Switch { get; } =
        new("Occupancy", "voxels around the vehicle, free or with class and object, and which of them the camera sees; simulation only");

    /// <inheritdoc />
    public override int? BitsPerPixel => BitsOfClasses;

    /// <inheritdoc />
    public override int? BitsOf(IChannelLabel label, string file) =>
        label is OccupancyLabel map && file == map.Instances ? BitsOfInstances : BitsOfClasses;

    /// <inheritdoc />
    public override (int Width, int Height) SizeOf(IChannelLabel label, CameraLabel camera) =>
        label is OccupancyLabel { Shape: var shape } ? (shape.Cells, shape.Cells * shape.Layers) : base.SizeOf(label, camera);

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<OccupancyLabel>();

    /// <summary>Paths of the maps of a frame.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static (string Map, string Instances, string Visible) FilesOf(int frame, string? view) =>
        (FramePaths.Map(MapFolder, frame, view), FramePaths.Map(InstanceFolder, frame, view), FramePaths.Map(VisibleFolder, frame, view));

    /// <inheritdoc />
    public override IChannelLabel Read(IJsonFields frame)
    {
        IJsonFields map = frame.Fields(Key);
        var shape = new VoxelShape(map.Integer("cells"), map.Integer("layers"), map.Number("cellMetres"), map.Number("lowestMetres"));
        double[] origin = map.Numbers("origin");
        return shape.Problem is { } problem ? throw map.Refusal($"occupancy has no such box. {problem}")
            : origin.Length != Axes ? throw map.Refusal("occupancy has an origin of other than three numbers.")
            : new OccupancyLabel(
                PictureName(map, "file"),
                PictureName(map, "instances"),
                PictureName(map, "visible"),
                shape,
                new Vector3D(origin[0], origin[1], origin[2])
            );
    }

    internal override void Append(JsonText json, IChannelLabel label)
    {
        var map = (OccupancyLabel)label;
        json.BeginObject()
            .Key("file")
            .String(map.File)
            .Key("instances")
            .String(map.Instances)
            .Key("visible")
            .String(map.Visible)
            .Key("cells")
            .Integer(map.Shape.Cells)
            .Key("layers")
            .Integer(map.Shape.Layers)
            .Key("cellMetres")
            .Number(map.Shape.CellMetres, LabelDecimals.Metres)
            .Key("lowestMetres")
            .Number(map.Shape.LowestMetres, LabelDecimals.Metres)
            .Key("origin")
            .Exact(map.Origin)
            .EndObject();
    }
}
