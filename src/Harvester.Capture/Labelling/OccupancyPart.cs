using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>The voxels of a frame.</summary>
/// <param name="map">What is in each.</param>
/// <param name="origin">The origin of their frame in the frame of the ego's model, metres.</param>
/// <param name="ids">The ids of the objects by handle.</param>
/// <param name="seen">Whether the camera sees each.</param>
public sealed class OccupancyPart(VoxelMap map, Vector3D origin, IReadOnlyDictionary<int, int> ids, IReadOnlyList<bool> seen) : FramePart
{
    /// <summary>What is in each voxel.</summary>
    public VoxelMap Map => map;

    /// <summary>Whether the camera sees each voxel, by its number.</summary>
    public IReadOnlyList<bool> Seen => seen;

    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents =>
        [
            Layers(voxel => map.Kinds[voxel]),
            (stream, png) => png.Write(Instances(), stream),
            Layers(voxel => seen[voxel] ? OccupancyLabel.Seen : (byte)0),
        ];

    private ImageSize Size => new(map.Grid.Shape.Cells, map.Grid.Shape.Cells * map.Grid.Shape.Layers);

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key)
    {
        (string classes, string instances, string visible) = OccupancyChannel.FilesOf(key.Frame, key.View);
        return new OccupancyLabel(classes, instances, visible, map.Grid.Shape, origin);
    }

    private FileContent Layers(Func<int, byte> valueOf) =>
        (stream, png) =>
            png.WriteGrey8(
                Size,
                (row, line) =>
                {
                    for (int column = 0; column < line.Length; column++)
                    {
                        line[column] = valueOf((row * line.Length) + column);
                    }
                },
                stream
            );

    private InstanceMap Instances()
    {
        var found = new InstanceMap(Size);
        for (int voxel = 0; voxel < found.Ids.Length; voxel++)
        {
            if (map.Owners[voxel] is not 0 and var owner && ids.TryGetValue(owner, out int id))
            {
                found.Ids[voxel] = (ushort)id;
            }
        }

        return found;
    }
}
