using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Assembly;

/// <summary>
/// The frames of all sessions of an export, session by session, with sequence and split. Each place that a session visits begins a new
/// sequence, and each view of a rig is a sequence of its own; all views of a moment are in the same split.
/// </summary>
internal static class PlannedFrames
{
    /// <summary>Reads the frames.</summary>
    /// <exception cref="DatasetFormatException">A label line is invalid.</exception>
    public static IEnumerable<ExportFrame> Of(ExportPlan plan)
    {
        var selector = new ObjectSelector(plan.Format, plan.Options);
        int index = 0;
        int sequences = 0;
        for (int session = 0; session < plan.Sessions.Count; session++)
        {
            SessionInfo info = plan.Sessions[session].ReadInfo();
            string?[] views = info.Rig is { } rig ? [.. rig.Cameras.Select(camera => camera.Name)] : [null];
            var inSession = new int[views.Length];
            var inSequence = new int[views.Length];
            var cameras = new CameraLabel?[views.Length];
            var times = new double?[views.Length];
            int? place = null;
            foreach (LabelLine line in plan.Sessions[session].ReadGoodLines())
            {
                int view = views.Length == 1 ? 0 : ViewOf(line, views, plan.Sessions[session]);
                int here = line.Label!.Place ?? 0;
                if (place is { } before && before != here)
                {
                    sequences += views.Length;
                    Array.Clear(inSequence);
                    Array.Clear(cameras);
                    Array.Clear(times);
                }

                place = here;
                yield return new ExportFrame(plan.Sessions[session], line, selector, plan.Options.ImageFormat, info.HasMeasuredPaint)
                {
                    Index = index++,
                    SequenceIndex = sequences + view,
                    FrameInSequence = inSequence[view]++,
                    RecordingIndex = session,
                    Rig = info.Rig,
                    ImuNoise = info.ImuNoise,
                    RateHz = info.RateHz ?? 0,
                    Split = plan.Options.Splits.Of(new FramePlace(session, here, inSession[view])),
                    FrameInSession = inSession[view]++,
                    SequenceCamera = cameras[view] ??= line.Label.Camera,
                    SequenceTimeSeconds = times[view] ??= line.Label.TimeSeconds,
                };
            }

            sequences += views.Length;
        }
    }

    private static int ViewOf(LabelLine line, string?[] views, SessionReader session)
    {
        string? view = line.Label!.View;
        int index = Array.IndexOf(views, view);
        return index >= 0
            ? index
            : throw new DatasetFormatException(
                $"{session.PathOf(SessionReader.LabelsFile)}, line {line.Number}: view is '{view}', which is no camera of the rig."
            );
    }
}
