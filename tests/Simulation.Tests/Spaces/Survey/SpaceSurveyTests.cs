using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Capture.Spaces;
using Harvester.Capture.Spaces.Survey;
using Harvester.Geometry;

namespace Harvester.Simulation.Tests.Spaces.Survey;

public sealed class SpaceSurveyTests : IDisposable
{
    /// <summary>What the project asks of a face's place.</summary>
    private const double ToleranceMetres = 0.02;

    /// <summary>Rays for a sign or for a head; with one in every cell of the grid they would be some 16,000.</summary>
    private const int MostRays = 5_000;

    private static readonly Pose Place = new(new Vector3D(1200, -340, 25), Axes.FromHeading(77));

    private const double BudgetMilliseconds = 4;
    private const int RaysIntoSecondModel = 2_500;
    private SurveyFolder? _folder;
    private readonly string _path = Directory.CreateTempSubdirectory("harvester-survey-").FullName;

    public static TheoryData<string> Props => [.. KnownProps.All.Keys];

    public void Dispose() => Directory.Delete(_path, recursive: true);

    [Theory]
    [MemberData(nameof(Props))]
    public void Survey_finds_every_face_and_head_within_2_centimetres(string name)
    {
        PropStage stage = Run(name);

        Prop prop = KnownProps.All[name];
        IReadOnlyList<SpaceOfInterest> found = Reopened().Table.Of(name);
        Assert.Equal(prop.Faces.Count, found.Count);
        Assert.All(prop.Faces, face => Assert.Contains(found, space =>
            space.Facing == face.Facing && Front(space) is var front
            && Largest(face.Min - front.Min) < ToleranceMetres && Largest(face.Max - front.Max) < ToleranceMetres));
        Assert.All(found, space => Assert.Equal(Provenance.Measured, space.Provenance));
        Assert.Equal(0, stage.Standing);
        Assert.InRange(stage.RaysCast, 1, Math.Max(1, prop.Bones.Count) * MostRays);
    }

    [Fact]
    public void Survey_that_was_cut_off_goes_on_with_the_model_it_was_at()
    {
        var first = new PropStage(KnownProps.All, Place) { RaysUntilFailure = RaysIntoSecondModel };
        using (SpaceSurvey cut = Start(first, "plate", "octagon", "diamond"))
        {
            ToEnd(cut);
            Assert.Equal("The survey stopped: the game is gone", cut.Fault);
        }

        Assert.Equal(0, first.Standing);
        Assert.Empty(first.Asked);
        Assert.Equal(["plate", "octagon"], first.PutUpModels);
        PropStage second = Run("plate", "octagon", "diamond");

        Assert.Equal(["octagon", "diamond"], second.PutUpModels);
        Assert.Equal(["diamond", "octagon", "plate"], Reopened().Table.Spaces.Select(space => space.Model));
        Assert.DoesNotContain(Directory.GetFiles(_path), file => file.EndsWith(".partial", StringComparison.Ordinal));
    }

    [Fact]
    public void Survey_passes_over_a_model_that_the_game_lacks()
    {
        PropStage stage = Run("nothing", "plate");

        Assert.Equal(["plate"], stage.PutUpModels);
        Assert.True(Reopened().IsDone("nothing"));
    }

    [Fact]
    public void Survey_of_a_light_without_bones_of_its_heads_does_not_call_its_rows_measured()
    {
        var stage = new PropStage(KnownProps.All, Place);
        using (var survey = new SpaceSurvey(
            stage, [new SurveyedModel("octagon", ObjectClass.TrafficLight, string.Empty, string.Empty)], _folder = Reopened(), new PlayerClock(), BudgetMilliseconds))
        {
            ToEnd(survey);
        }

        Assert.Equal(Provenance.Derived, Assert.Single(Reopened().Table.Spaces).Provenance);
    }

    [Fact]
    public void Survey_that_is_disposed_leaves_nothing_standing()
    {
        var stage = new PropStage(KnownProps.All, Place);
        SpaceSurvey survey = Start(stage, "plate");
        while (stage.Standing == 0)
        {
            survey.Step();
        }

        survey.Dispose();

        Assert.Empty(stage.Asked);
        Assert.Equal(0, stage.Standing);
        Assert.True(survey.IsOver);
    }

    [Fact]
    public void Folder_with_a_row_that_is_refused_is_not_written_over()
    {
        File.WriteAllText(Path.Combine(_path, SurveyFolder.TableName), "prop_sign_road_01a,5,sign\n");

        Assert.Contains("line 1", Assert.Throws<IOException>(() => new SurveyFolder(_path)).Message, StringComparison.Ordinal);
    }

    private PropStage Run(params string[] names)
    {
        var stage = new PropStage(KnownProps.All, Place);
        using SpaceSurvey survey = Start(stage, names);
        ToEnd(survey);
        Assert.Null(survey.Fault);
        Assert.Equal(names.Length, survey.Done);
        return stage;
    }

    private SpaceSurvey Start(PropStage stage, params string[] names) => new(
        stage,
        names.Select(name => new SurveyedModel(name, ObjectClass.Sign, "a name", string.Empty)),
        _folder = Reopened(),
        new PlayerClock(),
        BudgetMilliseconds);

    /// <summary>The folder as another survey finds it.</summary>
    private SurveyFolder Reopened()
    {
        _folder?.Wait(TimeSpan.FromSeconds(30));
        return new SurveyFolder(_path);
    }

    private static void ToEnd(SpaceSurvey survey)
    {
        while (!survey.IsOver)
        {
            survey.Step();
        }
    }

    private static (Vector3D Min, Vector3D Max) Front(SpaceOfInterest space)
    {
        double y = space.Facing == Facing.Front ? space.FrontUpperLeft.Y : space.BackLowerRight.Y;
        return (
            new(space.FrontUpperLeft.X, y, space.BackLowerRight.Z), new(space.BackLowerRight.X, y, space.FrontUpperLeft.Z));
    }

    private static double Largest(Vector3D difference) => Math.Max(Math.Abs(difference.X), Math.Max(Math.Abs(difference.Y), Math.Abs(difference.Z)));
}
