using Harvester.Datasets.Validation;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Damage to the maps of voxels that leaves them readable.</summary>
public sealed class OccupancyCheckTests
{
    private const ushort Free = 0;
    private const ushort Road = 1;
    private const ushort Car = 11;
    private const ushort Enclosed = 255;
    private const ushort Seen = 255;

    private static readonly OccupancyLabel Label = new("classes", "ids", "seen", new VoxelShape(2, 1, 0.4, -1), Vector3D.Zero);

    [Fact]
    public void Sound_maps_have_no_problem() => Assert.Empty(Problems([Free, Road, Car, Enclosed], [0, 0, 7, 0], [Seen, Seen, 0, 0]));

    [Fact]
    public void Value_that_is_no_class_is_found() =>
        Assert.Equal(
            "map of voxels 'classes' has the value 22, which is no class. Values are 0 to 21 and 255.",
            Assert.Single(Problems([Free, 22, Car, Enclosed], [0, 0, 7, 0], [0, 0, 0, 0]))
        );

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(3)]
    public void Number_where_there_is_no_object_is_found(int voxel)
    {
        var ids = new ushort[4];
        ids[voxel] = 7;

        Assert.Equal(
            "map of voxels 'ids' has a number where 'classes' has no object.",
            Assert.Single(Problems([Free, Road, Car, Enclosed], ids, [0, 0, 0, 0]))
        );
    }

    [Fact]
    public void Value_between_seen_and_unseen_is_found() =>
        Assert.Equal(
            "map of voxels 'seen' has the value 1. Its voxels are 0 or 255.",
            Assert.Single(Problems([Free, Road, Car, Enclosed], [0, 0, 7, 0], [1, 0, 0, 0]))
        );

    [Fact]
    public void Enclosed_voxel_that_is_seen_is_found() =>
        Assert.Equal(
            "map of voxels 'seen' has a voxel that is seen where 'classes' says that it is enclosed.",
            Assert.Single(Problems([Free, Road, Car, Enclosed], [0, 0, 7, 0], [0, 0, 0, Seen]))
        );

    private static string[] Problems(ushort[] classes, ushort[] ids, ushort[] seen) =>
        [.. OccupancyCheck.Problems(Label, name => MapOf(name == Label.File ? classes : seen), _ => MapOf(ids))];

    private static InstanceMap MapOf(ushort[] values)
    {
        var map = new InstanceMap(new ImageSize(2, 2));
        values.CopyTo(map.Ids, 0);
        return map;
    }
}
