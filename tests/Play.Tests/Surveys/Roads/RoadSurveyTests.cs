using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Play.Surveys.Roads;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Surveys.Roads;

public sealed class RoadSurveyTests : IDisposable
{
    private const int Blocks = 4;
    private const double BlockSide = 60;
    private const int CallsPerStep = 40;

    private readonly string _file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());

    public void Dispose() => File.Delete(_file);

    [Fact]
    public void Step_over_a_drive_finds_all_nodes_and_links_with_lanes()
    {
        RoadNetwork town = Town();
        var survey = new RoadSurvey(new FakeRoadSource(town), callsPerStep: CallsPerStep);

        RoadSurveyStatus status = DriveThrough(survey, 0, Blocks * BlockSide);

        Assert.Equal((town.Nodes.Count, town.Links.Count, 0, true), (status.Nodes, status.Links, status.Waiting, status.IsLoaded));
        AssertSame(town, survey.ToNetwork());
    }

    [Fact]
    public void Step_before_nodes_are_loaded_queries_nothing_else()
    {
        var source = new FakeRoadSource(Town(), ticksUntilLoaded: 5);
        var survey = new RoadSurvey(source);
        for (int i = 0; i < 5; i++)
        {
            Assert.False(survey.Step(new Vector3D(100, 100, 10)).IsLoaded);
        }

        Assert.Equal(0, source.Calls);
        Assert.True(survey.Step(new Vector3D(100, 100, 10)).IsLoaded);
        Assert.True(source.Calls > 0);
    }

    [Fact]
    public void Step_respects_its_query_budget()
    {
        var source = new FakeRoadSource(Town());
        var survey = new RoadSurvey(source, callsPerStep: CallsPerStep);
        for (int i = 0; i < 50; i++)
        {
            int before = source.Calls;
            survey.Step(new Vector3D(100, 100, 10));
            Assert.InRange(source.Calls - before, 1, CallsPerStep);
        }
    }

    [Fact]
    public void Save_and_Load_resume_an_earlier_survey()
    {
        RoadNetwork town = Town();
        var first = new RoadSurvey(new FakeRoadSource(town));
        DriveThrough(first, 0, 0);
        RoadNetwork part = first.ToNetwork();
        Assert.InRange(part.Nodes.Count, 10, town.Nodes.Count - 10);
        Assert.Null(RoadSurveyFile.Load(_file));
        RoadSurveyFile.Save(_file, part);

        var second = new RoadSurvey(new FakeRoadSource(town), RoadSurveyFile.Load(_file));
        DriveThrough(second, Blocks * BlockSide, Blocks * BlockSide);
        RoadSurveyFile.Save(_file, second.ToNetwork());

        AssertSame(town, RoadSurveyFile.Load(_file)!);
    }

    [Fact]
    public void Step_ignores_impossible_answers()
    {
        var source = new BrokenRoadSource();
        var survey = new RoadSurvey(source);
        for (int i = 0; i < 20; i++)
        {
            survey.Step(Vector3D.Zero);
        }

        Assert.Empty(survey.ToNetwork().Links);
    }

    /// <summary>Drives northwards on one street after the other, 5 m a step, with some steps of standing at each end.</summary>
    private static RoadSurveyStatus DriveThrough(RoadSurvey survey, double fromX, double toX)
    {
        RoadSurveyStatus status = default;
        for (double x = fromX; x <= toX; x += BlockSide)
        {
            for (double y = 0; y <= Blocks * BlockSide; y += 5)
            {
                status = survey.Step(new Vector3D(x + 600, y - 300, 10));
            }
        }

        for (int i = 0; i < 200; i++)
        {
            status = survey.Step(new Vector3D(toX + 600, (Blocks * BlockSide) - 300, 10));
        }

        return status;
    }

    /// <summary>
    /// A grid of streets with a node every 20 m, some streets one-way, some with a median, near but not at multiples of the stored grid.
    /// </summary>
    private static RoadNetwork Town()
    {
        const double step = 20;
        const int perSide = (int)(Blocks * BlockSide / step) + 1;
        const int perBlock = (int)(BlockSide / step);
        var nodes = new List<RoadNode>();
        var links = new List<RoadLink>();
        var indices = new Dictionary<(int, int), int>();
        for (int i = 0; i < perSide; i++)
        {
            for (int j = 0; j < perSide; j++)
            {
                if (i % perBlock == 0 || j % perBlock == 0)
                {
                    bool isJunction = i % perBlock == 0 && j % perBlock == 0;
                    indices[(i, j)] = nodes.Count;
                    Vector3D stored = PathGrid.Truncate(
                        new Vector3D(600 + (i * step) + (0.3 * j), -300 + (j * step) - (0.2 * i), 10 + (0.07 * i))
                    );
                    nodes.Add(
                        new RoadNode(
                            500,
                            nodes.Count,
                            PathGrid.RemoveBias(stored),
                            "",
                            isJunction ? RoadNodeFlags.Junction : RoadNodeFlags.Highway
                        )
                        {
                            Density = i % 16,
                        }
                    );
                }
            }
        }

        foreach (((int i, int j), int index) in indices)
        {
            if (j % perBlock == 0 && indices.TryGetValue((i + 1, j), out int east))
            {
                links.Add(new RoadLink(index, east, 2, 1, 4, RoadLinkFlags.None));
            }

            if (i % perBlock == 0 && indices.TryGetValue((i, j + 1), out int north))
            {
                links.Add(new RoadLink(north, index, i == 0 ? 0 : 3, 1, null, RoadLinkFlags.None));
            }
        }

        return new RoadNetwork(nodes, links);
    }

    private static void AssertSame(RoadNetwork expected, RoadNetwork actual)
    {
        Assert.Equal(expected.Nodes.OrderBy(node => node.Number), actual.Nodes.OrderBy(node => node.Number));
        Assert.Equal(Described(expected), Described(actual));
    }

    private static IEnumerable<RoadLink> Described(RoadNetwork network) =>
        network
            .Links.Select(link => link with { From = network.Nodes[link.From].Number, To = network.Nodes[link.To].Number })
            .Select(link => link.From < link.To ? link : link.Reversed())
            .OrderBy(link => link.From)
            .ThenBy(link => link.To);
}
