using FsCheck.Fluent;
using Harvester.Geometry.Roads;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Roads;

public sealed class RoadIndexTests
{
    private const double Reach = 12;

    [Fact]
    public void Near_finds_every_link_within_range()
    {
        var random = new Random(12);
        RoadNode[] nodes =
        [
            .. Enumerable
                .Range(0, 300)
                .Select(i => new RoadNode(
                    0,
                    i,
                    new Vector3D(random.NextDouble() * 900, random.NextDouble() * 900, 0),
                    "",
                    RoadNodeFlags.None
                )),
        ];
        RoadLink[] links = [.. Enumerable.Range(0, 299).Select(i => new RoadLink(i, i + 1, 1, 1, null, RoadLinkFlags.None))];
        var curves = new RoadCurves(new RoadNetwork(nodes, links));
        var index = new RoadIndex(curves, _ => Reach);
        int found = 0;
        RandomCases.Check(
            500,
            Arb.Zip(RandomCases.Number(-50, 950), RandomCases.Number(-50, 950)),
            at =>
            {
                var place = new Vector3D(at.Item1, at.Item2, 0);
                HashSet<int> near = [.. index.Near(place)];
                for (int link = 0; link < links.Length; link++)
                {
                    RoadCurve curve = curves.Of(link);
                    double nearest = Enumerable.Range(0, 101).Min(step => (curve.PointAt(step / 100.0) - place).Length);
                    if (nearest <= Reach)
                    {
                        Assert.Contains(link, near);
                        found++;
                    }
                }
            }
        );

        Assert.True(found > 500);
    }

    [Fact]
    public void Near_without_roads_is_empty() =>
        Assert.Equal(0, new RoadIndex(new RoadCurves(new RoadNetwork([], [])), _ => Reach).Near(Vector3D.Zero).Count);
}
