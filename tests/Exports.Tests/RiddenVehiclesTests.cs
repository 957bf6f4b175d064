using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

public sealed class RiddenVehiclesTests
{
    private static readonly ObjectLabel Bicycle = new()
    {
        Id = 4,
        Class = ObjectClass.Bicycle,
        Model = "scorcher",
        HasRider = true,
        Box2D = new Box2D(10, 30, 30, 50),
        Box2DAmodal = new Box2D(10, 30, 30, 50),
        Box2DVisible = new Box2D(10, 40, 30, 50),
        TruncatedFraction = 0,
        OccludedFraction = 0.6,
        OcclusionMethod = OcclusionMethod.Rays,
        DistanceMetres = 10,
        Velocity = new Vector3D(0, 4, 0),
        Box3D = new Cuboid(new Vector3D(0, 10, 0.5), new Vector3D(0.3, 0.9, 0.5), Axes.Identity),
    };

    private static readonly ObjectLabel Rider = Bicycle with
    {
        Id = 5,
        Class = ObjectClass.Rider,
        Model = "a_m_y_roadcyc_01",
        HasRider = null,
        Vehicle = 4,
        Box2D = new Box2D(15, 0, 25, 40),
        Box2DAmodal = new Box2D(15, -10, 25, 40),
        Box2DVisible = new Box2D(15, 0, 25, 40),
        AmodalMask = new AmodalMask(15, 0, 10, 40, [0, 400]),
        TruncatedFraction = 0.2,
        OccludedFraction = 0.1,
        Box3D = new Cuboid(new Vector3D(0, 10, 1.2), new Vector3D(0.4, 0.4, 0.7), Axes.Identity),
    };

    [Fact]
    public void Two_wheeler_and_rider_are_one_object()
    {
        ObjectLabel joined = Assert.Single(Joined(Bicycle, Rider));

        Assert.Equal((4, ObjectClass.Bicycle, true), (joined.Id, joined.Class, joined.HasRider));
        Assert.Equal(new Box2D(10, 0, 30, 50), joined.Box2D);
        Assert.Equal(new Box2D(10, -10, 30, 50), joined.Box2DAmodal);
        Assert.Equal(new Box2D(10, 0, 30, 50), joined.Box2DVisible);
        Assert.Equal(new Box2D(15, 0, 25, 40), joined.Box2DWhole);
        Assert.Equal(0.1, joined.OccludedFraction);

        // The amodal boxes have 400 and 500 square pixels.
        Assert.Equal(0.2 * 500 / 900, joined.TruncatedFraction!, 12);
        Assert.Equal(0.4, joined.Box3D.HalfExtents.X, 12);
        Assert.Equal(0.9, joined.Box3D.HalfExtents.Y, 12);
        Assert.Equal(0.95, joined.Box3D.HalfExtents.Z, 12);
        Assert.Equal(0.95, joined.Box3D.Centre.Z, 12);
    }

    [Fact]
    public void Rider_whose_vehicle_is_not_listed_stays()
    {
        ObjectLabel[] objects = Joined(Bicycle with { Id = 6, HasRider = false }, Rider);

        Assert.Equal([6, 5], objects.Select(label => label.Id));
        Assert.Equal(Bicycle.Box3D, objects[0].Box3D);
    }

    [Fact]
    public void Cuboids_beyond_all_numbers_are_refused()
    {
        ObjectLabel far = Rider with { Box3D = new Cuboid(new Vector3D(0, 1.7e308, 0), new Vector3D(0.4, 0.4, 0.7), Axes.Identity) };
        ObjectLabel opposite = Bicycle with
        {
            Box3D = new Cuboid(new Vector3D(0, -1.7e308, 0), new Vector3D(0.3, 0.9, 0.5), Axes.Identity),
        };

        Assert.Contains(
            "impossibly far apart",
            Assert.Throws<DatasetFormatException>(() => Joined(opposite, far)).Message,
            StringComparison.Ordinal
        );
    }

    private static ObjectLabel[] Joined(params ObjectLabel[] objects)
    {
        using var session = new TestSession();
        return [.. RiddenVehicles.WithRiders(objects, session.Open().ReadLabels().First().Camera)];
    }
}
