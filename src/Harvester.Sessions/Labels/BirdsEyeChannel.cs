using Harvester.Geometry.Grids;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of bird's-eye maps: 8-bit greyscale PNG images of cells on the ground around the ego.</summary>
public sealed class BirdsEyeChannel : FrameChannel
{
    /// <summary>Folder of the maps of classes.</summary>
    public const string MapFolder = "birds-eye";

    /// <summary>Folder of the maps of visible cells.</summary>
    public const string VisibleFolder = "birds-eye-visible";

    /// <inheritdoc />
    public override string Key => "birdsEye";

    /// <inheritdoc />
    public override string FileKind => "bird's-eye map";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [MapFolder, VisibleFolder];

    /// <inheritdoc />
    public override ChannelSwitch Switch { get; } =
        new("BirdsEye", "maps of the ground around the vehicle from above: roads, lanes, lines, crossings, vehicles, people");

    /// <inheritdoc />
    public override int? BitsPerPixel => 8;

    /// <inheritdoc />
    public override (int Width, int Height) SizeOf(IChannelLabel label, CameraLabel camera) =>
        label is BirdsEyeLabel { Cells: var cells } ? (cells, cells) : base.SizeOf(label, camera);

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<BirdsEyeLabel>();

    /// <inheritdoc />
    public override bool OutlivesLens(IChannelLabel label) => label is BirdsEyeLabel { Visible: null };

    /// <summary>Paths of the maps of a frame.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static (string Map, string Visible) FilesOf(int frame, string? view) =>
        (FramePaths.Map(MapFolder, frame, view), FramePaths.Map(VisibleFolder, frame, view));

    /// <inheritdoc />
    public override IChannelLabel Read(IJsonFields frame)
    {
        IJsonFields map = frame.Fields(Key);
        int cells = map.Integer("cells");
        double cell = map.Number("cellMetres");
        return new GridShape(cells * cell, cell).Problem is { } problem
            ? throw map.Refusal($"birdsEye has no such grid. {problem}")
            : new BirdsEyeLabel(
                PictureName(map, "file"),
                map.Has("visible") ? PictureName(map, "visible") : null,
                cells,
                cell,
                map.Name<BirdsEyeSource>("source")
            );
    }

    internal override void Append(JsonText json, IChannelLabel label)
    {
        var map = (BirdsEyeLabel)label;
        json.BeginObject()
            .Key("file")
            .String(map.File)
            .Key("visible")
            .String(map.Visible)
            .Key("cells")
            .Integer(map.Cells)
            .Key("cellMetres")
            .Number(map.CellMetres, LabelDecimals.Metres)
            .Key("source")
            .String(JsonName.Of(map.Source))
            .EndObject();
    }
}
