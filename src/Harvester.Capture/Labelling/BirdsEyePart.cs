using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>The bird's-eye map of a frame.</summary>
/// <param name="shape">Its size.</param>
/// <param name="classes">The class of each cell, row by row.</param>
/// <param name="visible">Whether the camera sees each cell; null if that is unknown.</param>
/// <param name="source">Where the ground comes from.</param>
public sealed class BirdsEyePart(GridShape shape, IReadOnlyList<BirdsEyeClass> classes, IReadOnlyList<bool>? visible, BirdsEyeSource source)
    : FramePart
{
    /// <summary>The class of each cell, row by row.</summary>
    public IReadOnlyList<BirdsEyeClass> Classes => classes;

    /// <summary>Whether the camera sees each cell, row by row; null if that is unknown.</summary>
    public IReadOnlyList<bool>? Visible => visible;

    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents =>
        visible is null
            ? [Map(cell => (byte)classes[cell])]
            : [Map(cell => (byte)classes[cell]), Map(cell => visible[cell] ? BirdsEyeLabel.Seen : (byte)0)];

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key)
    {
        (string map, string seen) = BirdsEyeChannel.FilesOf(key.Frame, key.View);
        return new BirdsEyeLabel(map, visible is null ? null : seen, shape.Cells, shape.CellMetres, source);
    }

    private FileContent Map(Func<int, byte> valueOf) =>
        (stream, png) =>
            png.WriteGrey8(
                new ImageSize(shape.Cells, shape.Cells),
                (row, line) =>
                {
                    for (int column = 0; column < line.Length; column++)
                    {
                        line[column] = valueOf((row * shape.Cells) + column);
                    }
                },
                stream
            );
}
