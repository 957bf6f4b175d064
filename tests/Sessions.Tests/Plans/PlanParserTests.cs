using Harvester.Geometry;
using Harvester.Sessions.Plans;

namespace Harvester.Sessions.Tests.Plans;

public sealed class PlanParserTests
{
    private const string Minimal = """{"name":"p","places":[{"name":"a","x":1,"y":2}]}""";

    [Fact]
    public void Missing_fields_have_their_documented_defaults()
    {
        Plan plan = PlanParser.Read(Minimal).Plan!;

        Assert.Equal(
            ("p", 1, 1, 100, 10.0, 12.0),
            (plan.Name, plan.Seed, plan.Repetitions, plan.Frames, plan.Hz, plan.SpeedMetresPerSecond)
        );
        Assert.Equal((1.0, 1.0, 1.0, PlanMasks.Off), (plan.Traffic, plan.Pedestrians, plan.Parked, plan.Masks));
        Assert.Equal(["clear"], plan.Weathers);
        Assert.Equal([TimeSpan.FromHours(12)], plan.Hours);
        PlanCamera camera = Assert.Single(plan.Cameras);
        Assert.Equal(
            ("camera", 800, 600, 50.0, null),
            (camera.Name, camera.Image.Width, camera.Image.Height, camera.VerticalFovDegrees, camera.RigFile)
        );
        Assert.Equal(new Vector2D(1, 2), Assert.Single(plan.Places).Start);
    }

    [Fact]
    public void Path_begins_at_its_first_point()
    {
        PlanPlace place = PlanParser.Read("""{"name":"p","places":[{"name":"a","path":[[3,4],[5,6]],"seconds":2}],"hz":5}""").Plan!.Places[
            0
        ];

        Assert.Equal(new Vector2D(3, 4), place.Start);
        Assert.Equal(2, place.Path.Count);
    }

    [Fact]
    public void Seconds_limit_the_frames_of_a_trial()
    {
        Plan plan = PlanParser.Read("""{"name":"p","places":[{"name":"a","x":0,"y":0,"seconds":3}],"hz":5,"frames":40}""").Plan!;

        // 3 s at 5 Hz are 15 frames.
        Assert.Equal(15, plan.FramesAt(plan.Places[0]));
    }

    [Theory]
    [InlineData("""{"places":[{"name":"a","x":1,"y":2}]}""", "name is missing.")]
    [InlineData("""{"name":"p"}""", "places must be a list of 1 to 1000 objects.")]
    [InlineData(
        """{"name":"p","places":[{"name":"a"}]}""",
        "places[0].name must be followed by a place: 'a' needs x and y, space, spread, path or scenario."
    )]
    [InlineData("""{"name":"p","places":[{"name":"a","x":1}]}""", "places[0].y is missing.")]
    [InlineData(
        """{"name":"p","places":[{"name":"a b","x":1,"y":2}]}""",
        "places[0].name must be 1 to 30 letters, digits and -, beginning with a letter or digit, not 'a b'."
    )]
    [InlineData(
        """{"name":"p","places":[{"name":"a","x":1,"y":2},{"name":"A","x":1,"y":2}]}""",
        "places must have names that all differ, in capitals or not; 'a' occurs twice."
    )]
    [InlineData(
        """{"name":"p","places":[{"name":"a","spread":1,"z":3}]}""",
        "places[0].z is not a field of a plan. Correct its name or delete it."
    )]
    [InlineData(
        """{"name":"p","places":[{"name":"a","path":[[0,0],[0,0]]}]}""",
        "places[0].path must be a list of 2 to 100000 points, each unlike the one before."
    )]
    [InlineData(
        """{"name":"p","places":[{"name":"a","spread":1}],"wether":["rain"]}""",
        "wether is not a field of a plan. Correct its name or delete it."
    )]
    [InlineData(
        """{"name":"p","places":[{"name":"a","spread":1}],"hours":["25:00"]}""",
        "hours[0] must be a time of day such as 18:30, not '25:00'."
    )]
    [InlineData("""{"name":"p","places":[{"name":"a","spread":1}],"weathers":[]}""", "weathers must have at least one value.")]
    [InlineData(
        """{"name":"p","places":[{"name":"a","spread":1}],"weathers":["rain","rain"]}""",
        "weathers must be values that all differ."
    )]
    [InlineData("""{"name":"p","places":[{"name":"a","spread":1}],"frames":0}""", "frames must be a number from 1 to 1000000.")]
    [InlineData("""{"name":"p","places":[{"name":"a","spread":1}],"masks":"all"}""", "masks must be off, rays or coded, not 'all'.")]
    [InlineData(
        """{"name":"p","places":[{"name":"a","spread":1}],"cameras":[{"name":"c","rig":"../r.json"}]}""",
        "cameras[0].rig must be a path within the plan's folder, with forward slashes."
    )]
    [InlineData(
        """{"name":"p","places":[{"name":"a","spread":10000}],"repetitions":11}""",
        "places, weathers, hours, cameras and repetitions give 110000 trials; at most 100000 are allowed."
    )]
    public void Problem_is_one_line_that_names_the_field(string text, string problem) =>
        Assert.Equal([problem], PlanParser.Read(text).Problems);

    [Fact]
    public void Wrong_weather_is_named_with_all_weathers()
    {
        string problem = Assert.Single(
            PlanParser.Read("""{"name":"p","places":[{"name":"a","spread":1}],"weathers":["rain","sunny"]}""").Problems
        );

        Assert.StartsWith("weathers[1] must be one of clear, extrasunny,", problem, StringComparison.Ordinal);
        Assert.EndsWith(", not 'sunny'.", problem, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("""{"name":"a","x":1.25,"y":-2,"headingDegrees":30,"seconds":5}""")]
    [InlineData("""{"name":"a","path":[[0,1],[2,3.5]],"metres":7}""")]
    [InlineData("""{"name":"a","space":"STOP","metresBefore":12}""")]
    [InlineData("""{"name":"a","spread":4}""")]
    public void Written_plan_is_read_back(string place)
    {
        Plan plan = PlanParser
            .Read(
                $$"""
                {"name":"p","seed":3,"places":[{{place}}],"weathers":["rain","xmas"],"hours":["06:05"],"repetitions":2,"frames":7,"hz":0.5,
                "cameras":[{"name":"c","width":64,"height":48,"verticalFovDegrees":33.3},{"name":"r","rig":"rigs/r.json"}],"speed":9,
                "traffic":0.5,"pedestrians":2,"parked":0,"masks":"rays"}
                """
            )
            .Plan!;

        string text = PlanJson.Of(plan);

        Assert.Equal(text, PlanJson.Of(PlanParser.Read(text).Plan!));
        Assert.Equal(
            plan with
            {
                Places = [],
                Weathers = [],
                Hours = [],
                Cameras = [],
            },
            PlanParser.Read(text).Plan! with
            {
                Places = [],
                Weathers = [],
                Hours = [],
                Cameras = [],
            }
        );
        Assert.Equivalent(plan, PlanParser.Read(text).Plan, strict: true);
    }

    [Fact]
    public void All_problems_of_a_plan_are_found_at_once() =>
        Assert.Equal(4, PlanParser.Read("""{"name":"","places":[{"name":"a","x":"1","y":2}],"hz":0,"extra":1}""").Problems.Count);

    [Fact]
    public void Text_that_is_no_json_is_one_problem() => Assert.Single(PlanParser.Read("{").Problems);
}
