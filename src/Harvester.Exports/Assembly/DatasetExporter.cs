using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Assembly;

/// <summary>
/// Exports sessions to a dataset, frame by frame. A stopped export resumes when it is run again with the same plan. Shards are exports of
/// every n-th frame, which <see cref="DatasetMerger"/> merges.
/// </summary>
public sealed class DatasetExporter
{
    private readonly ExportPlan _asked;
    private readonly DatasetFolder _folder;
    private readonly Shard _shard;

    /// <summary>Prepares an export.</summary>
    /// <param name="plan">The plan of the export.</param>
    /// <param name="folder">Folder to write to: new, empty, or with a stopped export of the same plan.</param>
    /// <param name="shard">The shard to export.</param>
    /// <param name="sync">When to wait for the disk.</param>
    /// <exception cref="ArgumentException">The format cannot keep the splits apart.</exception>
    public DatasetExporter(ExportPlan plan, string folder, Shard shard, SyncMode sync = SyncMode.Batch)
    {
        if (plan.Format.ProblemOf(plan.Options.Splits.Splits) is { } problem)
        {
            throw new ArgumentException(problem, nameof(plan));
        }

        SplitPlan splits = plan.Options.Splits;
        _asked = plan.Format.KeepsSequences
            ? plan with
            {
                Options = plan.Options with { Splits = new SplitPlan(splits.Splits, splits.Seed) },
            }
            : plan;
        _folder = new DatasetFolder(folder, sync);
        _shard = shard;
    }

    /// <summary>Space that stays free on the disk, bytes: the export stops before less is left. 0 watches nothing.</summary>
    public long MinFreeBytes { get; init; }

    /// <summary>Whether a finished export of the same plan is accepted as the result; otherwise it is refused.</summary>
    public bool Resumes { get; init; }

    /// <summary>
    /// How many frames follow a frame of the same place in another split. Such neighbours look alike, so that a split with one of them
    /// does not test on unseen images. 0 before <see cref="Run"/>.
    /// </summary>
    public int SeparatedNeighbours { get; private set; }

    /// <summary>Runs the export.</summary>
    /// <param name="report">Receives the number of frames after each frame.</param>
    /// <param name="cancellation">Stops between two frames.</param>
    /// <exception cref="DatasetFormatException">A session is invalid, or the format cannot represent it.</exception>
    /// <exception cref="OccupiedFolderException">The folder has other files.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public ExportResult Run(Action<int> report, CancellationToken cancellation = default)
    {
        // Reading all labels takes long, so a folder that cannot be used is refused before.
        bool mayBeDone = Resumes && _folder.IsFinished && _shard.Count == 1;
        if (!mayBeDone)
        {
            _folder.CheckUsable();
        }

        FfmpegProgram.CheckFor(_asked.Format);
        Journal.CheckDivision(_folder, _shard);
        SessionSurvey survey = SessionSurvey.Of(_asked, cancellation);
        SeparatedNeighbours = survey.SeparatedNeighbours;
        ExportPlan plan = survey.Decide();
        string identity = plan.Identity;
        if ((mayBeDone || _folder.HasLeftovers) && DatasetAssembly.PlanOf(_folder) == identity)
        {
            if (_folder.HasLeftovers)
            {
                _folder.Finish();
            }

            return DatasetAssembly.ResultOf(_folder);
        }

        _folder.CheckUnfinished();

        // Problems of the sessions are reported before anything is written.
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

        string path = Journal.PathOf(_folder, _shard);
        if (_shard.Count == 1)
        {
            return DatasetAssembly.Finish(_folder, [path]);
        }

        _folder.DeleteLeftoversOf(Journal.Read(path).SelectMany(entry => entry.Files).Select(file => file.Key));
        return new ExportResult(plan.Format, frames, IsFinished: false);
    }

    private void WriteFrames(ExportPlan plan, Journal journal, Action<int> report, CancellationToken cancellation)
    {
        PictureEncoder? encoder = plan.Options.ImageFormat is { } format ? new PictureEncoder(format, plan.Options.JpegQuality) : null;
        IDatasetWriter writer = plan.Format.CreateWriter(plan.Options);
        using var digests = new ImageDigests();
        var space = new SpaceWatch(_folder.Path, MinFreeBytes);
        try
        {
            int last = journal.LastFrame;
            foreach (ExportFrame frame in PlannedFrames.Of(plan).Where(frame => _shard.Takes(frame.Index) && frame.Index > last))
            {
                cancellation.ThrowIfCancellationRequested();
                space.Check();
                var output = new FrameOutput(_folder, plan.Options.Images, encoder, digests.Of);
                WrittenObjects written = writer.Write(frame, output);
                journal.Append(
                    new JournalEntry(
                        frame.Index,
                        frame.Split,
                        frame.Label.Objects.Count,
                        frame.PostCount,
                        written,
                        output.Files,
                        output.Parts
                    )
                );
                report(journal.Frames);
            }
        }
        catch (Exception e) when (e is OperationCanceledException or DatasetFormatException or LowSpaceException)
        {
            // The disk is well: the frames whose lines are held back need not be written again.
            journal.Commit();
            throw;
        }
    }
}
