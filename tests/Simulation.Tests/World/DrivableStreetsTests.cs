using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.World;

/// <summary>Streets of difficult networks can be driven, and stand on something.</summary>
public sealed class DrivableStreetsTests
{
    private const double Everywhere = 2000;

    /// <summary>Longest deck without a support, metres: three spans, because piers leave out lower roads.</summary>
    private const double MaxSpan = 75;

    public static TheoryData<string> Layouts => new(Layout.Names);

    [Theory]
    [MemberData(nameof(Layouts))]
    public void Lanes_have_ground_below_and_space_above(string layout)
    {
        Site site = SiteOf(layout);
        LaneJudge judge = new(site.Ground);

        LaneFault[] faults = [.. judge.Faults(site.Lanes.Paths)];

        Assert.True(judge.Judged > 500, $"Only {judge.Judged} points judged.");
        Assert.True(faults.Length == 0, $"{faults.Length} faults: {string.Join("; ", faults.Take(5))}");
    }

    [Fact]
    public void Lanes_of_the_generated_town_can_be_driven()
    {
        Site site = SiteCache.Shared.Town(1);

        LaneFault[] faults = [.. new LaneJudge(site.Ground).Faults(site.Lanes.Paths)];

        Assert.True(faults.Length == 0, $"{faults.Length} faults: {string.Join("; ", faults.Take(5))}");
    }

    [Theory]
    [InlineData("crossing")]
    [InlineData("ramp")]
    [InlineData("interchange")]
    public void Decks_stand_on_piers_and_abutments(string layout)
    {
        Site site = SiteOf(layout);
        SceneRayCaster rays = new(new RenderScene(site.Ground));
        double longest = 0;
        double decks = 0;
        foreach (Road road in site.Plan.Roads)
        {
            const double step = 1;
            double unsupported = 0;
            for (double distance = 0; distance + step < road.Length; distance += step)
            {
                const double belowDeck = 1.5;
                Vector3D place = road.Curve.PositionAt(distance) - (Horizontal.Up * belowDeck);
                Vector3D next = road.Curve.PositionAt(distance + step) - (Horizontal.Up * belowDeck);
                bool isOpen = place.Z - site.Terrain.HeightAt(place) > 0.5;
                bool isSupported = !isOpen || rays.Cast(new Ray(place, next - place), (next - place).Length, RayHit.World) is not null;
                unsupported = isSupported ? 0 : unsupported + step;
                decks += isOpen ? step : 0;
                longest = Math.Max(longest, unsupported);
            }
        }

        Assert.True(decks > 15, $"Only {decks} m of decks.");
        Assert.InRange(longest, 0, MaxSpan);
    }

    [Fact]
    public void Roads_in_tunnels_have_a_ceiling_and_walls_and_others_none()
    {
        // Lorries are up to 4.3 m high; the ceiling lies a little above that.
        const double highest = 6;
        const double eye = 1;
        const double reach = 30;
        Site site = SiteOf("tunnel");
        SceneRayCaster rays = new(new RenderScene(site.Ground));
        int covered = 0;
        foreach (Road road in site.Plan.Roads)
        {
            for (double distance = 5; distance < road.Length - 5; distance += 10)
            {
                CrossSection section = road.Curve.SectionAt(distance);
                Vector3D place = section.Centre + (Horizontal.Up * eye);
                bool hasCeiling = rays.Cast(new Ray(place, Horizontal.Up), highest, RayHit.World) is not null;
                Assert.Equal(road.IsInTunnel, hasCeiling);
                if (hasCeiling)
                {
                    covered++;
                    Assert.NotNull(rays.Cast(new Ray(place, section.Right), reach, RayHit.World));
                    Assert.NotNull(rays.Cast(new Ray(place, -section.Right), reach, RayHit.World));
                }
            }
        }

        Assert.True(covered > 25, $"Only {covered} places are covered.");
    }

    [Theory]
    [MemberData(nameof(Layouts))]
    public void No_building_stands_on_a_carriageway(string layout) => AssertBuildingsAreOffRoads(SiteOf(layout));

    [Fact]
    public void Generated_town_has_high_rises_in_its_centre_only()
    {
        Site site = SiteCache.Shared.Town(1);
        AssertBuildingsAreOffRoads(site);
        Prop[] high = [.. BuildingsOf(site).Where(building => building.Model.Max.Z > HighRise)];
        Assert.NotEmpty(high);

        // The centre reaches to 200 m; a building belongs to the place of its street.
        Assert.All(high, building => Assert.InRange(Horizontal.Distance(building.Pose.Position, Vector3D.Zero), 0, 260));
    }

    /// <summary>Height of a high-rise, metres.</summary>
    internal const double HighRise = 25;

    internal static List<Prop> BuildingsOf(Site site)
    {
        Scenery scenery = new(1, site, ModelCatalogue.Shared, new HandleCounter());
        scenery.AddAlong(site.Walkways);
        new Countryside(1, site, scenery).AddAlong(site.Plan);
        return [.. scenery.Props.Where(prop => prop.Model.Name.StartsWith("building_", StringComparison.Ordinal))];
    }

    /// <summary>No point of any lane, with a car's half width on both sides, lies within a building's walls.</summary>
    internal static void AssertBuildingsAreOffRoads(Site site)
    {
        const double halfCar = 1;
        const double step = 3;
        List<Prop> buildings = BuildingsOf(site);
        foreach (LanePath lane in site.Lanes.Paths)
        {
            for (double distance = 0; distance < lane.Length; distance += step)
            {
                Vector3D place = lane.Line.PositionAt(distance);
                Prop? hit = buildings.Find(building =>
                {
                    Vector3D offset = building.Pose.ToLocal(place with { Z = building.Pose.Position.Z });
                    return offset.X > building.Model.Min.X - halfCar
                        && offset.X < building.Model.Max.X + halfCar
                        && offset.Y > building.Model.Min.Y - halfCar
                        && offset.Y < building.Model.Max.Y + halfCar;
                });
                Assert.True(
                    hit is null,
                    $"{hit?.Model.Name} at {hit?.Pose.Position.X:F1},{hit?.Pose.Position.Y:F1} stands on a lane at "
                        + $"{place.X:F1},{place.Y:F1}, {(lane.Road is null ? "in a junction" : $"on road {lane.Road.Index}")}."
                );
            }
        }
    }

    private static Site SiteOf(string layout) => Site.OfRoads(1, Layout.Named(layout), Vector3D.Zero, Everywhere);
}
