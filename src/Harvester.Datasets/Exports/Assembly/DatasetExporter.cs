using System;
using System.IO;
using System.Linq;
using System.Threading;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Datasets.Exports.Assembly;

/// <summary>
/// Turns sessions into a dataset, frame by frame. An export that was stopped goes on where it was when it is run again with the same
/// plan; shards are exports of every n-th frame that <see cref="DatasetMerger"/> puts together.
/// </summary>
public sealed class DatasetExporter
{
    private readonly ExportPlan _asked;
    private readonly DatasetFolder _folder;
    private readonly Shard _shard;

    /// <summary>Plans an export.</summary>
    /// <param name="plan">What to do.</param>
    /// <param name="folder">Where the dataset goes: a new or empty folder, or one with an export of the same plan that was stopped.</param>
    /// <param name="shard">Which frames.</param>
    public DatasetExporter(ExportPlan plan, string folder, Shard shard)
    {
        _asked = plan.Format.KeepsSessions
            ? plan with
            {
                Options =
                plan.Options with { Splits = new SplitPlan(plan.Options.Splits.Splits, plan.Options.Splits.Seed, int.MaxValue) }
            }
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
        // Reading all labels takes long: a folder that can never be written to is refused before.
        _folder.CheckUsable();
        SessionSurvey survey = SessionSurvey.Of(_asked, cancellation);
        ExportPlan plan = survey.Decide();
        string identity = plan.Identity;
        if (_folder.HasLeftovers && DatasetAssembly.PlanOf(_folder) == identity)
        {
            _folder.Finish();
            return DatasetAssembly.ResultOf(_folder);
        }

        _folder.CheckUnfinished();

        // Whatever the sessions lack is refused before there is anything to go on with.
        survey.Check();
        _folder.Begin(identity);
        int frames;
        using (var journal = new Journal(_folder, _shard))
        {
            if (!journal.IsEnded)
            {
                WriteFrames(plan, journal, report, cancellation);
                journal.End();
            }

            frames = journal.Frames;
        }

        return _shard.Count > 1
            ? new ExportResult(plan.Format, frames, IsFinished: false)
            : DatasetAssembly.Finish(_folder, [Journal.PathOf(_folder, _shard)]);
    }

    private void WriteFrames(ExportPlan plan, Journal journal, Action<int> report, CancellationToken cancellation)
    {
        PictureEncoder? encoder = plan.Options.ImageFormat is { } format ? new PictureEncoder(format, plan.Options.JpegQuality) : null;
        IDatasetWriter writer = plan.Format.CreateWriter(plan.Options);
        foreach (ExportFrame frame in PlannedFrames.Of(plan).Where(frame => _shard.Takes(frame.Index) && frame.Index > journal.LastFrame))
        {
            cancellation.ThrowIfCancellationRequested();
            var output = new FrameOutput(_folder, plan.Options.Images, encoder);
            WrittenObjects written = writer.Write(frame, output);
            journal.Append(new JournalEntry(frame.Index, frame.Split, frame.Label.Objects.Count, written, output.Files, output.Parts));
            report(journal.Frames);
        }
    }
}
