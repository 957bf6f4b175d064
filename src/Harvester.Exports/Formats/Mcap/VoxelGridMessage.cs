using System.Buffers.Binary;
using Foxglove;
using Google.Protobuf;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;
using Element = Foxglove.PackedElementField;
using Kind = Foxglove.PackedElementField.Types.NumericType;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>The message of the voxels around the vehicle: a box in the ego frame, whose x is ahead and y to the left.</summary>
internal static class VoxelGridMessage
{
    private const int CellBytes = 8;

    /// <summary>A message is held in memory several times; this many voxels make 32 MB.</summary>
    private const int MaxVoxels = 4_000_000;

    private const int AlphaAt = 3;
    private const int ClassAt = 4;
    private const int VisibleAt = 5;
    private const int ObjectAt = 6;

    private static readonly (string Name, int Offset, Kind Kind)[] Fields =
    [
        ("red", 0, Kind.Uint8),
        ("green", 1, Kind.Uint8),
        ("blue", 2, Kind.Uint8),
        ("alpha", AlphaAt, Kind.Uint8),
        ("class", ClassAt, Kind.Uint8),
        ("visible", VisibleAt, Kind.Uint8),
        ("object", ObjectAt, Kind.Uint16),
    ];

    /// <summary>Writes the message.</summary>
    /// <param name="frame">The frame of the moment's first view.</param>
    /// <param name="label">What its label says of the voxels.</param>
    /// <param name="nanoseconds">The moment, nanoseconds.</param>
    /// <exception cref="Harvester.Sessions.Reading.Files.DatasetFormatException">
    /// A map cannot be read, or the voxels are too many.
    /// </exception>
    public static byte[] Of(ExportFrame frame, OccupancyLabel label, long nanoseconds)
    {
        VoxelShape shape = label.Shape;
        if (shape.Count > MaxVoxels)
        {
            throw frame.Problem(FormattableString.Invariant($"it has {shape.Count} voxels, and mcap takes at most {MaxVoxels}."));
        }

        double half = shape.Cells * shape.CellMetres / 2;
        return new Foxglove.VoxelGrid
        {
            Timestamp = MessageTime.Of(nanoseconds),
            FrameId = FoxgloveMessages.Ego,
            Pose = new Pose
            {
                Position = VectorOf(label.Origin.Y - half, -label.Origin.X - half, label.Origin.Z + shape.LowestMetres),
                Orientation = new Quaternion { W = 1 },
            },
            RowCount = (uint)shape.Cells,
            ColumnCount = (uint)shape.Cells,
            CellSize = VectorOf(shape.CellMetres, shape.CellMetres, shape.CellMetres),
            SliceStride = (uint)(shape.Cells * shape.Cells * CellBytes),
            RowStride = (uint)(shape.Cells * CellBytes),
            CellStride = CellBytes,
            Fields =
            {
                Fields.Select(field => new Element
                {
                    Name = field.Name,
                    Offset = (uint)field.Offset,
                    Type = field.Kind,
                }),
            },
            Data = UnsafeByteOperations.UnsafeWrap(DataOf(frame, label)),
        }.ToByteArray();
    }

    /// <summary>The voxels slice by slice from below, in rows from the right to the left, each from the rear ahead.</summary>
    private static byte[] DataOf(ExportFrame frame, OccupancyLabel label)
    {
        VoxelShape shape = label.Shape;
        ushort[] classes = frame.ReadVoxels(label.File, shape);
        ushort[] owners = frame.ReadVoxels(label.Instances, shape, hasIds: true);
        ushort[][] seen = [.. VisibleIn(frame, label).Select(name => frame.ReadVoxels(name, shape))];
        byte[] data = new byte[shape.Count * CellBytes];
        int at = 0;
        for (int layer = 0; layer < shape.Layers; layer++)
        {
            for (int column = shape.Cells - 1; column >= 0; column--)
            {
                for (int row = shape.Cells - 1; row >= 0; row--, at += CellBytes)
                {
                    int voxel = (((layer * shape.Cells) + row) * shape.Cells) + column;
                    ushort kind = classes[voxel];
                    if (kind is not VoxelMap.Free and <= SemanticClasses.Greatest)
                    {
                        (data[at], data[at + 1], data[at + 2]) = SemanticClasses.ColourOf((SemanticClass)kind);
                        data[at + AlphaAt] = byte.MaxValue;
                    }

                    data[at + ClassAt] = (byte)kind;
                    data[at + VisibleAt] = Array.Exists(seen, view => view[voxel] == OccupancyLabel.Seen) ? OccupancyLabel.Seen : (byte)0;
                    BinaryPrimitives.WriteUInt16LittleEndian(data.AsSpan(at + ObjectAt), owners[voxel]);
                }
            }
        }

        return data;
    }

    /// <summary>The maps of what the cameras of the moment see; a repaired session may lack some.</summary>
    private static IEnumerable<string> VisibleIn(ExportFrame frame, OccupancyLabel label) =>
        frame.Rig is { } rig
            ? rig
                .Cameras.Select((camera, view) => OccupancyChannel.FilesOf(frame.Label.Frame + view, camera.Name).Visible)
                .Where(frame.HasFile)
            : [label.Visible];

    private static Vector3 VectorOf(double x, double y, double z) =>
        new()
        {
            X = x,
            Y = y,
            Z = z,
        };
}
