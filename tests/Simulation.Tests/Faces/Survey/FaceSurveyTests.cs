using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Tests.Faces.Survey;

public sealed class SpaceSurveyTests : IDisposable
{
    /// <summary>The required accuracy of a face's position.</summary>
    private const double ToleranceMetres = 0.02;

    /// <summary>Rays for a sign or for a head; with one in every cell of the grid they would be some 16,000.</summary>
    private const int MaxRays = 5_000;

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
        IReadOnlyList<ModelFace> found = Reopened().Table.Of(name);
        Assert.Equal(prop.Faces.Count, found.Count);
        Assert.All(
            prop.Faces,
            face =>
                Assert.Contains(
                    found,
                    row =>
                        row.Facing == face.Facing
                        && Front(row) is var front
                        && Largest(face.Min - front.Min) < ToleranceMetres
                        && Largest(face.Max - front.Max) < ToleranceMetres
                )
        );
        Assert.All(found, face => Assert.Equal(Provenance.Measured, face.Provenance));
        Assert.Equal(0, stage.Standing);
        Assert.InRange(stage.RaysCast, 1, Math.Max(1, prop.Bones.Count) * MaxRays);
    }

    [Fact]
    public void Interrupted_survey_resumes_with_the_current_model()
    {
        var first = new PropStage(KnownProps.All, Place) { RaysUntilFailure = RaysIntoSecondModel };
        using (FaceSurvey cut = Start(first, "plate", "octagon", "diamond"))
        {
            ToEnd(cut);
            Assert.Equal("The survey stopped: the game is gone", cut.Fault);
        }

        Assert.Equal(0, first.Standing);
        Assert.Empty(first.Asked);
        Assert.Equal(["plate", "octagon"], first.PutUpModels);
        PropStage second = Run("plate", "octagon", "diamond");

        Assert.Equal(["octagon", "diamond"], second.PutUpModels);
        Assert.Equal(["diamond", "octagon", "plate"], Reopened().Table.Faces.Select(face => face.Model));
        Assert.DoesNotContain(Directory.GetFiles(_path), file => file.EndsWith(".partial", StringComparison.Ordinal));
    }

    [Fact]
    public void Survey_skips_a_model_missing_from_the_game()
    {
        PropStage stage = Run("nothing", "plate");

        Assert.Equal(["plate"], stage.PutUpModels);
        Assert.True(Reopened().IsDone("nothing"));
    }

    [Fact]
    public void Survey_of_a_light_without_head_bones_gives_derived_rows()
    {
        var stage = new PropStage(KnownProps.All, Place);
        using (
            var survey = new FaceSurvey(
                stage,
                [new SurveyedModel("octagon", ObjectClass.TrafficLight, string.Empty, string.Empty)],
                _folder = Reopened(),
                new PlayerClock(),
                BudgetMilliseconds
            )
        )
        {
            ToEnd(survey);
        }

        Assert.Equal(Provenance.Derived, Assert.Single(Reopened().Table.Faces).Provenance);
    }

    [Fact]
    public void Survey_replaces_faces_that_rays_find_and_keeps_the_back()
    {
        ModelFace back = Known("plate", 1, Facing.Front);
        var model = new SurveyedModel("plate", ObjectClass.Sign, "STOP", "R1-1")
        {
            Known = [Known("plate", 0, Facing.Back), back, Known("plate", 2, Facing.Back)],
        };
        Survey(model);

        IReadOnlyList<ModelFace> faces = Reopened().Table.Of("plate");
        Assert.Equal(
            [("STOP", Provenance.Measured), (back.Name, Provenance.Estimated)],
            faces.Select(face => (face.Name, face.Provenance))
        );
        Assert.Equal(back, faces[1]);

        // A second survey measures the front again and finds the back among the player's own rows.
        File.Delete(Path.Combine(_path, "models.txt"));
        Survey(model with { Known = [] });
        Assert.Equal(["STOP", back.Name], Reopened().Table.Of("plate").Select(face => face.Name));
    }

    [Fact]
    public void Survey_drops_a_first_face_guessed_in_the_wrong_direction()
    {
        Survey(new SurveyedModel("plate", ObjectClass.Sign, "STOP", "R1-1") { Known = [Known("plate", 0, Facing.Front)] });

        Assert.Equal(Facing.Back, Assert.Single(Reopened().Table.Of("plate")).Facing);
    }

    [Fact]
    public void Survey_that_finds_more_faces_renumbers_the_kept_one()
    {
        Survey(
            new SurveyedModel("two", ObjectClass.Sign, "STOP", "R1-1")
            {
                Known = [Known("two", 0, Facing.Back), Known("two", 1, Facing.Front)],
            }
        );

        Assert.Equal(
            [(0, Facing.Back), (1, Facing.Back), (2, Facing.Front)],
            Reopened().Table.Of("two").Select(face => (face.Number, face.Facing))
        );
    }

    [Fact]
    public void Survey_of_a_light_drops_heads_it_did_not_find()
    {
        const string light = "prop_traffic_01a";
        ModelFace estimated = Known(light, 9, Facing.Front) with { Class = ObjectClass.TrafficLight };
        Survey(new SurveyedModel(light, ObjectClass.TrafficLight, "", "") { Known = [Known(light, 0, Facing.Back), estimated] });

        Assert.DoesNotContain(Reopened().Table.Of(light), head => head.Provenance == Provenance.Estimated);
    }

    [Fact]
    public void Disposed_survey_removes_its_models()
    {
        var stage = new PropStage(KnownProps.All, Place);
        FaceSurvey survey = Start(stage, "plate");
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
    public void Folder_with_an_invalid_row_is_not_overwritten()
    {
        File.WriteAllText(Path.Combine(_path, SurveyFolder.TableName), "prop_sign_road_01a,5,sign\n");

        Assert.Contains("line 1", Assert.Throws<IOException>(() => new SurveyFolder(_path)).Message, StringComparison.Ordinal);
    }

    private void Survey(SurveyedModel model)
    {
        using var survey = new FaceSurvey(
            new PropStage(KnownProps.All, Place),
            [model],
            _folder = Reopened(),
            new PlayerClock(),
            BudgetMilliseconds
        );
        ToEnd(survey);
        Assert.Null(survey.Fault);
    }

    private static ModelFace Known(string model, int face, Facing facing) =>
        new(
            model,
            ModelHash.Of(model),
            ObjectClass.Sign,
            $"known {face}",
            "",
            face,
            new(-0.4, 0.02, 2.6),
            new(0.4, -0.04, 1.9),
            facing,
            Provenance.Estimated,
            "test"
        );

    private PropStage Run(params string[] names)
    {
        var stage = new PropStage(KnownProps.All, Place);
        using FaceSurvey survey = Start(stage, names);
        ToEnd(survey);
        Assert.Null(survey.Fault);
        Assert.Equal(names.Length, survey.Done);
        return stage;
    }

    private FaceSurvey Start(PropStage stage, params string[] names) =>
        new(
            stage,
            names.Select(name => new SurveyedModel(name, ObjectClass.Sign, "a name", string.Empty)),
            _folder = Reopened(),
            new PlayerClock(),
            BudgetMilliseconds
        );

    /// <summary>The folder as another survey finds it.</summary>
    private SurveyFolder Reopened()
    {
        _folder?.Wait(TimeSpan.FromSeconds(30));
        return new SurveyFolder(_path);
    }

    private static void ToEnd(FaceSurvey survey)
    {
        while (!survey.IsOver)
        {
            survey.Step();
        }
    }

    private static (Vector3D Min, Vector3D Max) Front(ModelFace face)
    {
        double y = face.Facing == Facing.Front ? face.FrontUpperLeft.Y : face.BackLowerRight.Y;
        return (new(face.FrontUpperLeft.X, y, face.BackLowerRight.Z), new(face.BackLowerRight.X, y, face.FrontUpperLeft.Z));
    }

    private static double Largest(Vector3D difference) =>
        Math.Max(Math.Abs(difference.X), Math.Max(Math.Abs(difference.Y), Math.Abs(difference.Z)));
}
