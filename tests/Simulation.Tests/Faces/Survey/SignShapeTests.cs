using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Faces.Survey;

/// <summary>The survey of signs over all shapes, sides and posts, with the one face that each of them has.</summary>
public sealed class SignShapeTests(ITestOutputHelper output) : IDisposable
{
    /// <summary>The required accuracy of a face's position.</summary>
    private const double ToleranceMetres = 0.02;

    /// <summary>What a sign may cost, as in the test of known props.</summary>
    private const int MaxRays = 5_000;

    private readonly string _path = Directory.CreateTempSubdirectory("harvester-shapes-").FullName;

    public static TheoryData<string, Facing> Signs
    {
        get
        {
            var signs = new TheoryData<string, Facing>();
            foreach (string outline in SignShapes.Outlines)
            {
                signs.Add(outline, Facing.Back);
                signs.Add(outline, Facing.Front);
            }

            return signs;
        }
    }

    public void Dispose() => Directory.Delete(_path, recursive: true);

    [Theory]
    [MemberData(nameof(Signs))]
    [Trait("Category", "Heavy")]
    public void Survey_finds_the_one_face_of_each_sign_within_2_centimetres(string outline, Facing facing)
    {
        IReadOnlyDictionary<string, Prop> signs = SignShapes.Of(outline, facing);
        List<string> wrong = [];
        double largest = 0;
        foreach ((string name, Prop sign) in signs)
        {
            (IReadOnlyList<ModelFace> found, int rays) = Survey(name, sign);
            double error = found.Count == 1 ? Error(sign, found[0]) : double.PositiveInfinity;
            largest = Math.Max(largest, error);
            if (error > ToleranceMetres || rays > MaxRays)
            {
                wrong.Add(string.Create(CultureInfo.InvariantCulture, $"{name}: {found.Count} faces, {error:0.000} m, {rays} rays"));
            }
        }

        output.WriteLine(
            string.Create(CultureInfo.InvariantCulture, $"{signs.Count - wrong.Count} of {signs.Count} right, {largest:0.0000} m at most")
        );
        wrong.ForEach(output.WriteLine);
        Assert.Empty(wrong);
    }

    private (IReadOnlyList<ModelFace> Found, int Rays) Survey(string name, Prop sign)
    {
        var stage = new PropStage(
            new Dictionary<string, Prop> { ["sign"] = sign },
            new Pose(new Vector3D(1200, -340, 25), Axes.FromHeading(77))
        );
        var folder = new SurveyFolder(
            Directory.CreateDirectory(Path.Combine(_path, ModelHash.Of(name).ToString(CultureInfo.InvariantCulture))).FullName
        );
        using var survey = new FaceSurvey(
            stage,
            [new SurveyedModel("sign", ObjectClass.Sign, "a name", string.Empty)],
            folder,
            new PlayerClock(),
            double.PositiveInfinity
        );
        while (!survey.IsOver)
        {
            survey.Step();
        }

        Assert.Null(survey.Fault);
        return (folder.Table.Of("sign"), stage.RaysCast);
    }

    /// <summary>
    /// The largest distance of an edge or of the plane from where it truly is; infinite where the face looks the other way.
    /// </summary>
    private static double Error(Prop sign, ModelFace found)
    {
        (Vector3D min, Vector3D max, Facing facing) = sign.Faces[0];
        double[] apart =
        [
            found.FrontUpperLeft.X - min.X,
            found.BackLowerRight.X - max.X,
            found.BackLowerRight.Z - min.Z,
            found.FrontUpperLeft.Z - max.Z,
            found.FrontUpperLeft.Y - min.Y,
            found.BackLowerRight.Y - min.Y,
        ];
        return found.Facing == facing ? apart.Max(Math.Abs) : double.PositiveInfinity;
    }
}
