using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labels;
using Harvester.Datasets.Exports.Assembly;
using Harvester.Datasets.Sessions;

namespace Harvester.Datasets.Exports;

/// <summary>
/// Turns sessions into a dataset, frame by frame. An export that was stopped goes on where it was when it is run again with the same
/// plan; shards are exports of every n-th frame that <see cref="DatasetMerger"/> puts together.
/// </summary>
public sealed class DatasetExporter
{
    private readonly ExportPlan _plan;
    private readonly DatasetFolder _folder;
    private readonly Shard _shard;

    /// <summary>Plans an export.</summary>
    /// <param name="plan">What to do.</param>
    /// <param name="folder">Where the dataset goes: a new or empty folder, or one with an export of the same plan that was stopped.</param>
    /// <param name="shard">Which frames.</param>
    public DatasetExporter(ExportPlan plan, string folder, Shard shard)
    {
        _plan = plan.Format.KeepsSessions
            ? plan with { Options = plan.Options with { Splits = new SplitPlan(plan.Options.Splits.Splits, plan.Options.Splits.Seed, int.MaxValue) } }
            : plan;
        _folder = new DatasetFolder(folder);
        _shard = shard;
    }

    /// <summary>Exports.</summary>
    /// <param name="report">Is told the number of frames done after each.</param>
    /// <param name="cancellation">Stops between two frames.</param>
    /// <exception cref="DatasetFormatException">A session is malformed, or has what the format cannot say.</exception>
    /// <exception cref="OccupiedFolderException">The folder holds something else.</exception>
    /// <exception cref="IOException">Something cannot be read or written.</exception>
    public ExportResult Run(Action<int> report, CancellationToken cancellation = default)
    {
        string identity = _plan.Identity;
        if (_folder.HasLeftovers && DatasetAssembly.PlanOf(_folder) == identity)
        {
            _folder.Finish();
            return DatasetAssembly.ResultOf(_folder);
        }

        if (_folder.IsFinished)
        {
            throw new OccupiedFolderException($"'{_folder.Path}' holds a finished dataset already. Name another folder.");
        }

        // What the first frame cannot be said in is refused before there is anything to go on with.
        if (!_folder.IsBegun && Frames().FirstOrDefault() is { } first)
        {
            Check(first);
        }

        _folder.Begin(identity);
        int frames;
        using (var journal = new Journal(_folder, _shard))
        {
            if (!journal.IsEnded)
            {
                WriteFrames(journal, report, cancellation);
                journal.End();
            }

            frames = journal.Frames;
        }

        return _shard.Count > 1
            ? new ExportResult(_plan.Format, frames, IsFinished: false)
            : DatasetAssembly.Finish(_folder, [Journal.PathOf(_folder, _shard)]);
    }

    private void WriteFrames(Journal journal, Action<int> report, CancellationToken cancellation)
    {
        IDatasetWriter writer = _plan.Format.CreateWriter(_plan.Options);
        foreach (ExportFrame frame in Frames().Where(frame => _shard.Takes(frame.Index) && frame.Index > journal.LastFrame))
        {
            cancellation.ThrowIfCancellationRequested();
            Check(frame);
            var output = new FrameOutput(_folder, _plan.Options.Images);
            int objects = writer.Write(frame, output);
            journal.Append(new JournalEntry(frame.Index, frame.Split, frame.Label.Objects.Count, objects, output.Files, output.Parts));
            report(journal.Frames);
        }
    }

    private IEnumerable<ExportFrame> Frames()
    {
        int index = 0;
        for (int session = 0; session < _plan.Sessions.Count; session++)
        {
            int frameInSession = 0;
            CameraLabel? camera = null;
            foreach (LabelLine line in _plan.Sessions[session].ReadGoodLines())
            {
                camera ??= line.Label!.Camera;
                yield return new ExportFrame(_plan.Sessions[session], line, _plan.Options)
                {
                    Index = index++,
                    SessionIndex = session,
                    FrameInSession = frameInSession,
                    Split = _plan.Options.Splits.Of(session, frameInSession),
                    SessionCamera = camera,
                };
                frameInSession++;
            }
        }
    }

    private void Check(ExportFrame frame)
    {
        if (_plan.Format.NeedsMasks && frame.Label.Mask is null)
        {
            throw frame.Problem($"it has no mask, and {_plan.Format.Name} needs one. Harvest with masks, or choose another format.");
        }

        if (_plan.Format.NeedsLanes && frame.Label.Lanes is null)
        {
            throw frame.Problem($"it has no lanes, and {_plan.Format.Name} is about nothing else. Harvest with roads, or choose another format.");
        }

        if (_plan.Format.NeedsRectilinear && LensBend.PixelsOf(frame.Label.Camera) is var bend and > LensBend.MostPixels)
        {
            throw frame.Problem(FormattableString.Invariant(
                $"its lens bends straight lines by {bend:0.0} pixels, and {_plan.Format.Name} has no words for that. Choose another format."));
        }
    }
}
