using Foxglove;
using Google.Protobuf;
using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Element = Foxglove.PackedElementField;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>The message of a bird's-eye map: a grid in the world whose x is the ego's right and whose y is its heading.</summary>
internal static class GridMessage
{
    private static readonly string[] LayerNames = ["class", "visible"];

    private const string World = "world";

    /// <summary>Writes the message.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="map">What its label says of the map.</param>
    /// <param name="nanoseconds">The moment, nanoseconds.</param>
    /// <exception cref="Harvester.Sessions.Reading.Files.DatasetFormatException">A map cannot be read.</exception>
    public static byte[] Of(ExportFrame frame, BirdsEyeLabel map, long nanoseconds)
    {
        EgoLabel ego = frame.Label.Ego;
        var pose = new Geometry.Pose(ego.Position, ego.Axes ?? Axes.FromHeading(ego.HeadingDegrees));
        double height = ego.HeightAboveGroundMetres ?? 0;
        var grid = new EgoGrid(pose, height, new GridShape(map.Cells * map.CellMetres, map.CellMetres));
        int last = grid.Cells - 1;
        Vector2D corner = grid.CentreOf(0, last);
        Vector2D right = (grid.CentreOf(1, last) - corner) * 0.5;
        Vector2D ahead = (grid.CentreOf(0, last - 1) - corner) * 0.5;
        corner = corner - right - ahead;
        Rotation heading = Rotation.OfSensor(Axes.FromHeading(Angles.HeadingDegrees(new Vector3D(ahead.X, ahead.Y, 0))));
        InstanceMap[] layers = [.. map.Files.Select(name => frame.ReadCells(name, "bird's-eye map", map.Cells))];
        return new Grid
        {
            Timestamp = MessageTime.Of(nanoseconds),
            FrameId = World,
            Pose = new Foxglove.Pose
            {
                Position = new Foxglove.Vector3
                {
                    X = corner.X,
                    Y = corner.Y,
                    Z = ego.Position.Z - height,
                },
                Orientation = new Foxglove.Quaternion
                {
                    X = heading.X,
                    Y = heading.Y,
                    Z = heading.Z,
                    W = heading.W,
                },
            },
            ColumnCount = (uint)map.Cells,
            CellSize = new Vector2 { X = map.CellMetres, Y = map.CellMetres },
            RowStride = (uint)(map.Cells * layers.Length),
            CellStride = (uint)layers.Length,
            Fields = { LayerNames.Take(layers.Length).Select(FieldOf) },
            Data = UnsafeByteOperations.UnsafeWrap(DataOf(layers, map.Cells)),
        }.ToByteArray();
    }

    private static Element FieldOf(string name, int offset) =>
        new()
        {
            Name = name,
            Offset = (uint)offset,
            Type = Element.Types.NumericType.Uint8,
        };

    /// <summary>The cells from the rear to the front, as y grows ahead.</summary>
    private static byte[] DataOf(InstanceMap[] layers, int cells)
    {
        byte[] data = new byte[cells * cells * layers.Length];
        int at = 0;
        for (int row = cells - 1; row >= 0; row--)
        {
            for (int column = 0; column < cells; column++)
            {
                foreach (InstanceMap layer in layers)
                {
                    data[at++] = (byte)layer.Ids[(row * cells) + column];
                }
            }
        }

        return data;
    }
}
