using Harvester.Geometry;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Reports.Comparison;

/// <summary>A session as a dataset to compare. Labels are streamed.</summary>
public sealed class ComparedSession : IComparedDataset
{
    private readonly SessionReader _session;
    private readonly ClassScheme _scheme;
    private readonly List<string> _images = [];

    private ComparedSession(SessionReader session, ClassScheme scheme)
    {
        _session = session;
        _scheme = scheme;
        Length = session.CountLines();
    }

    /// <inheritdoc />
    public int Length { get; }

    /// <inheritdoc />
    public string Unit => "frames";

    /// <inheritdoc />
    public IReadOnlyList<string> Images => _images;

    /// <summary>A session in its own terms.</summary>
    public static ComparedSession InItsTerms(SessionReader session) => new(session, ClassScheme.Session);

    /// <summary>A session in KITTI's terms: without signs, traffic lights and parts.</summary>
    public static ComparedSession InKittiTerms(SessionReader session) => new(session, ClassScheme.Kitti);

    /// <summary>A session in the terms of nuScenes: without signs, traffic lights and parts.</summary>
    public static ComparedSession InNuScenesTerms(SessionReader session) => new(session, ClassScheme.NuScenes);

    /// <inheritdoc />
    public DatasetProfile Read(Action<int> report, CancellationToken cancellation)
    {
        var profile = new DatasetProfile(Path.GetFileName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(_session.Folder))));
        HashSet<int> sampled = [.. EvenSelection.Of(Length, ImageBrightness.MaxImages)];
        foreach ((int index, FrameLabel frame) in _session.ReadLabels().Index())
        {
            cancellation.ThrowIfCancellationRequested();
            profile.AddFrame(_scheme.ObjectsOf(frame).Count(label => Add(profile, frame.Camera, label)));
            if (sampled.Contains(index))
            {
                _images.Add(_session.PathOf(frame.Image));
            }

            report(index + 1);
        }

        return profile;
    }

    private bool Add(DatasetProfile profile, CameraLabel camera, ObjectLabel label)
    {
        if (_scheme.ClassOf(label) is not { } kind)
        {
            return false;
        }

        profile.Add(
            new ComparedObject(
                kind,
                ClassScheme.TypeOf(label),
                label.Box2D,
                label.DistanceMetres,
                label.TruncatedFraction,
                label.OccludedFraction,
                _scheme.LevelOf(label),
                ObservationOf(label, camera)
            )
        );
        return true;
    }

    /// <summary>KITTI's alpha of an object, radians: KITTI's x, y and z are the camera's right, down and forward.</summary>
    private static double ObservationOf(ObjectLabel label, CameraLabel camera)
    {
        Vector3D centre = camera.Pose.ToLocal(label.Box3D.Centre);
        Vector3D forward = camera.Pose.Axes.ToLocal(label.Box3D.Axes.Forward);
        return Math.Atan2(0 - forward.Y, forward.X) - Math.Atan2(centre.X, centre.Y);
    }
}
