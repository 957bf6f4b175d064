using Harvester.Geometry.Cameras;
using Harvester.Geometry.Depth;

namespace Harvester.Geometry.Tests.Depth;

public sealed class DepthMapperTests
{
    /// <summary>Planes are extended in double precision.</summary>
    private const double Rounding = 1e-9;

    private const int Focal = 200;

    private static readonly ImageSize Image = new(100, 80);

    [Fact]
    public void Plane_is_complete_from_the_coarse_grid()
    {
        DepthMapper mapper = Mapper(null, static (_, _) => (Floor, 0, 0));
        DepthMap map = Run(mapper);

        // Seven by five cells have 8 by 6 corners and 35 middles.
        Assert.Equal(48 + 35, mapper.RaysCast);
        for (int at = 0; at < map.Metres.Length; at++)
        {
            // The floor is 2 m below the eye.
            Vector3D direction = DirectionOf(at % Image.Width, at / Image.Width);
            Assert.Equal(2 / -direction.Z, map.Metres[at], Rounding * map.Metres[at]);
            Assert.InRange(map.ErrorMetres[at], 0, Rounding * map.Metres[at]);
        }
    }

    [Fact]
    public void Depth_jumps_where_the_mask_says()
    {
        ushort[] regions = [.. Enumerable.Range(0, Image.PixelCount).Select(at => (ushort)(at % Image.Width is > 36 and < 57 ? 3 : 0))];
        DepthMap map = Run(Mapper(regions, static (column, _) => column is > 36 and < 57 ? (Wall, 7, 3) : (Floor, 0, 0)));

        for (int at = 0; at < map.Metres.Length; at++)
        {
            bool isWall = at % Image.Width is > 36 and < 57;
            double wanted = isWall ? 5 : 2 / -DirectionOf(at % Image.Width, at / Image.Width).Z;
            Assert.Equal(wanted, map.Metres[at], Rounding * wanted);
        }
    }

    [Fact]
    public void Jump_without_a_mask_gets_most_rays_and_an_error()
    {
        DepthMapper mapper = Mapper(null, static (column, _) => column > 36 ? (Wall, 7, 0) : (Floor, 0, 0));
        DepthMap map = Run(mapper);

        // The coarse grid has 83; a division between left and right takes two.
        Assert.InRange(mapper.RaysCast, 2 * 83, 800);
        for (int at = 0; at < map.Metres.Length; at++)
        {
            double wanted = at % Image.Width > 36 ? 5 : 2 / -DirectionOf(at % Image.Width, at / Image.Width).Z;
            Assert.InRange(Math.Abs(map.Metres[at] - wanted), 0, map.ErrorMetres[at] + (Rounding * wanted));
        }
    }

    [Fact]
    public void Nothing_seen_is_no_depth()
    {
        DepthMap map = Run(
            new DepthMapper(new DepthGrid(Image, LineOf), static (_, _) => new DepthSample(double.PositiveInfinity, default, 0, 0), 1000)
        );

        Assert.All(map.Metres, depth => Assert.Equal(double.PositiveInfinity, depth));
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(-1, 0)]
    [InlineData(0.001, 1)]
    [InlineData(1, 256)]
    [InlineData(255.996, 65535)]
    [InlineData(256, 0)]
    [InlineData(double.PositiveInfinity, 0)]
    [InlineData(double.NaN, 0)]
    public void Depths_are_in_256ths_of_a_metre(double metres, int units) => Assert.Equal(units, DepthUnits.OfDepth(metres));

    [Theory]
    [InlineData(0, 1)]
    [InlineData(0.0040, 2)]
    [InlineData(1, 256)]
    [InlineData(1000, 65535)]
    [InlineData(double.PositiveInfinity, 65535)]
    public void Errors_are_rounded_up(double metres, int units) => Assert.Equal(units, DepthUnits.OfError(metres));

    [Fact]
    public void Budget_is_kept()
    {
        DepthMapper mapper = Mapper(null, static (column, row) => ((column + row) % 2 == 0 ? Wall : Floor, 0, 0), budget: 150);
        Run(mapper);

        Assert.InRange(mapper.RaysCast, 145, 150);
    }

    private static Vector3D Floor => new(0, 0, -0.5);

    private static Vector3D Wall => new(0, 0.2, 0);

    private static DepthMap Run(DepthMapper mapper)
    {
        while (mapper.Step()) { }

        return mapper.Complete();
    }

    private static DepthMapper Mapper(
        ushort[]? regions,
        Func<int, int, (Vector3D Plane, int Entity, int Region)> seen,
        int budget = 2000
    ) =>
        new(
            new DepthGrid(Image, LineOf) { Regions = regions },
            (column, row) =>
            {
                (Vector3D plane, int entity, int region) = seen(column, row);
                return new DepthSample(1 / plane.Dot(DirectionOf(column, row)), new SurfacePlane(plane), entity, (ushort)region);
            },
            budget
        );

    private static SightLine LineOf(int column, int row) => new(DirectionOf(column, row));

    /// <summary>All rows are below the horizon, so that each sees the floor.</summary>
    private static Vector3D DirectionOf(int column, int row) => new((column - 50 + 0.5) / Focal, 1, -(row + 40.5) / Focal);
}
