using System.Collections.Generic;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports.Assembly;

/// <summary>The frames of all sessions of an export, session by session, with place and split.</summary>
internal static class PlannedFrames
{
    /// <summary>Reads the frames.</summary>
    /// <exception cref="DatasetFormatException">A label line is invalid.</exception>
    public static IEnumerable<ExportFrame> Of(ExportPlan plan)
    {
        var selector = new ObjectSelector(plan.Format, plan.Options);
        int index = 0;
        for (int session = 0; session < plan.Sessions.Count; session++)
        {
            int frameInSession = 0;
            CameraLabel? camera = null;
            foreach (LabelLine line in plan.Sessions[session].ReadGoodLines())
            {
                camera ??= line.Label!.Camera;
                yield return new ExportFrame(plan.Sessions[session], line, selector, plan.Options.ImageFormat)
                {
                    Index = index++,
                    SessionIndex = session,
                    FrameInSession = frameInSession,
                    Split = plan.Options.Splits.Of(session, frameInSession),
                    SessionCamera = camera,
                };
                frameInSession++;
            }
        }
    }
}
