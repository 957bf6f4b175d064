using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// Photographs a model from the side of its first face, and from the opposite side. A picture that is refused repeatedly is left out.
/// </summary>
internal sealed class ModelPhotographer(ISurveyCamera camera, SurveyFolder folder)
{
    private const double VerticalFovDegrees = 50;

    /// <summary>Ticks from moving the camera until the picture shows it; the picture may lag some ticks behind the game.</summary>
    private const int SettlingTicks = 6;

    private const int MaxGrabs = 10;

    /// <summary>Size of the picture relative to that of the faces.</summary>
    private const double Surroundings = 1.5;

    private const double MinDistance = 1;

    /// <summary>Whether it needs the screen.</summary>
    public bool IsAtWork { get; private set; }

    /// <summary>Takes the photographs, one tick per element.</summary>
    public IEnumerable<WorkStep> Take(StagedModel model, string name, IReadOnlyList<MeasuredFace> faces)
    {
        Vector3D min = faces.Count == 0 ? model.Min : Least(faces.Select(face => face.Min));
        Vector3D max = faces.Count == 0 ? model.Max : -Least(faces.Select(face => -face.Max));
        Vector3D towards = Outward(faces.Count == 0 ? Facing.Back : faces[0].Facing);
        IsAtWork = true;
        foreach ((string file, Vector3D outward) in new[] { (name + ".png", towards), (name + "_back.png", -towards) })
        {
            Pose eye = EyeOf(min, max, outward);
            if (!camera.LookFrom(model.Pose.Compose(eye), VerticalFovDegrees))
            {
                break;
            }

            for (int tick = 0; tick < SettlingTicks; tick++)
            {
                yield return WorkStep.Tick;
            }

            PixelBuffer? picture = camera.Grab();
            for (int grabs = 1; picture is null && grabs < MaxGrabs; grabs++)
            {
                yield return WorkStep.Tick;
                picture = camera.Grab();
            }

            if (picture is not null)
            {
                folder.Keep(new SurveyPhoto(file, name, eye, VerticalFovDegrees), picture);
            }
        }

        LookAway();
    }

    /// <summary>Restores the player's view. Calling it again has no effect.</summary>
    public void LookAway()
    {
        IsAtWork = false;
        camera.LookAway();
    }

    /// <summary>The camera pose from which a square picture shows a box from one side, in the model's frame.</summary>
    private static Pose EyeOf(Vector3D min, Vector3D max, Vector3D outward)
    {
        Vector3D forward = -outward;
        var up = new Vector3D(0, 0, 1);
        Vector3D right = forward.Cross(up);
        Vector3D half = (max - min) * 0.5;
        double halfWidth = Math.Abs(half.X * right.X) + Math.Abs(half.Y * right.Y);
        double halfDepth = Math.Abs(half.X * forward.X) + Math.Abs(half.Y * forward.Y);
        double distance = Surroundings * Math.Max(halfWidth, half.Z) / Math.Tan(Angles.ToRadians(VerticalFovDegrees) / 2);
        return new Pose(
            ((min + max) * 0.5) + (outward * (Math.Max(distance, MinDistance) + halfDepth)),
            Axes.FromVectors(right, forward, up)
        );
    }

    private static Vector3D Outward(Facing facing) =>
        facing switch
        {
            Facing.Front => new Vector3D(0, 1, 0),
            Facing.Left => new Vector3D(-1, 0, 0),
            Facing.Right => new Vector3D(1, 0, 0),
            _ => new Vector3D(0, -1, 0),
        };

    private static Vector3D Least(IEnumerable<Vector3D> points) =>
        points.Aggregate((a, b) => new Vector3D(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z)));
}
