using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Assembly;

/// <summary>Reads the sessions of an export once, to check before anything is written that the export is possible.</summary>
internal sealed class SessionSurvey
{
    /// <summary>Four months of driving at one frame a second; each is held.</summary>
    private const int MaxFrames = 10_000_000;

    /// <summary>The manual has about 1,000.</summary>
    private const int MaxMutcdCodes = 10_000;

    private readonly ExportPlan _plan;
    private readonly List<FramePlace> _written = [];
    private readonly Dictionary<int, string> _last = [];
    private readonly int[] _frames;
    private readonly int[] _masks;
    private readonly int[] _classMaps;
    private bool _hasWholeBoxes;
    private readonly SortedSet<string> _mutcdCodes = new(StringComparer.Ordinal);

    private SessionSurvey(ExportPlan plan)
    {
        _plan = plan;
        _frames = new int[plan.Sessions.Count];
        _masks = new int[plan.Sessions.Count];
        _classMaps = new int[plan.Sessions.Count];
    }

    private DatasetFormat Format => _plan.Format;

    /// <summary>How many frames follow a frame of the same sequence in another split.</summary>
    public int SeparatedNeighbours { get; private set; }

    private bool HasMasks => _masks.Sum() > 0;

    /// <summary>Whether labels depend on masks, as they do unless the boxes ignore masks.</summary>
    private bool DependsOnMasks =>
        Format.UsesMasks && !(Format.HasBoxes && !Format.HasSegmentations && _plan.Options.Boxes is BoxKind.Amodal or BoxKind.Cuboid);

    /// <summary>Reads all labels of all sessions.</summary>
    /// <exception cref="DatasetFormatException">A session is invalid, or the format cannot represent one of its frames.</exception>
    public static SessionSurvey Of(ExportPlan plan, CancellationToken cancellation)
    {
        foreach (SessionReader session in plan.Sessions)
        {
            if (SessionHeader.Read(session).Shard is { } shard)
            {
                throw new DatasetFormatException(
                    $"'{session.Folder}' is shard {shard} of a session. Merge the shards first: harvester merge."
                );
            }
        }

        var survey = new SessionSurvey(plan);
        foreach (ExportFrame frame in PlannedFrames.Of(plan))
        {
            cancellation.ThrowIfCancellationRequested();
            survey.Add(frame);
        }

        return survey;
    }

    /// <summary>The plan, completed with the options that depend on the sessions.</summary>
    public ExportPlan Decide()
    {
        ExportOptions options = _plan.Options;
        BoxKind boxes = !Format.HasBoxes
            ? Format.NeedsMasks
                ? BoxKind.Visible
                : BoxKind.Cuboid
            : options.Boxes ?? (HasMasks ? BoxKind.Visible : BoxKind.Cuboid);
        return _plan with
        {
            Options = options with
            {
                Boxes = boxes,
                HasClassMaps = _classMaps.Sum() > 0,
                Parts = options.Parts ?? Format.DefaultParts,
                MutcdCodes = options.Subclasses.HasFlag(Subclasses.Mutcd) ? [.. _mutcdCodes] : [],
            },
        };
    }

    /// <summary>Throws if the dataset cannot be made from the sessions.</summary>
    /// <exception cref="DatasetFormatException">A session or split has no frames, or only some of the frames have masks.</exception>
    public void Check()
    {
        int empty = Array.IndexOf(_frames, 0);
        if (empty >= 0)
        {
            throw new DatasetFormatException($"'{FolderOf(empty)}' has no frames.");
        }

        CheckMasks();
        CheckClassMaps();
        if (_written.Count == 0)
        {
            throw new DatasetFormatException(
                Format.NeedsFlow
                    ? $"No frame has a flow from a frame before, which {Format.Name} needs. Harvest with --flow, or choose another format."
                    : $"No frame has lanes, which {Format.Name} needs. Harvest with roads, or choose another format."
            );
        }

        SplitPlan splits = _plan.Options.Splits;
        if (splits.FirstEmpty(_written) is { } split)
        {
            throw new DatasetFormatException($"The split '{split}' would be empty: " + AdviceFor(splits));
        }
    }

    private void Add(ExportFrame frame)
    {
        FrameRequirements.Check(Format, _plan.Options, frame);
        _frames[frame.RecordingIndex]++;
        _classMaps[frame.RecordingIndex] += frame.Label.ClassMap is null ? 0 : 1;
        _masks[frame.RecordingIndex] += frame.Label.Mask is null ? 0 : 1;
        _hasWholeBoxes |= frame.Label.Objects.Any(label => label.Box2DWhole is not null);
        _mutcdCodes.UnionWith(frame.Label.Objects.Select(label => label.Face?.MutcdCode).OfType<string>());
        if (
            (!Format.LeavesOutUnknownLanes || frame.Label.Lanes is { Status: LaneStatus.Known })
            && (!Format.NeedsFlow || frame.Flow is not null)
        )
        {
            _written.Add(new FramePlace(frame.RecordingIndex, frame.Label.Place ?? 0, frame.FrameInSession));
            SeparatedNeighbours += _last.TryGetValue(frame.SequenceIndex, out string? split) && split != frame.Split ? 1 : 0;
            _last[frame.SequenceIndex] = frame.Split;
        }

        if (_written.Count > MaxFrames || _mutcdCodes.Count > MaxMutcdCodes)
        {
            throw new DatasetFormatException(
                $"An export takes at most {MaxFrames} frames and {MaxMutcdCodes} MUTCD codes. Export the sessions separately."
            );
        }
    }

    private void CheckMasks()
    {
        if (_plan.Options.Boxes == BoxKind.Whole && !_hasWholeBoxes)
        {
            throw new DatasetFormatException(
                "Boxes of whole objects need amodal masks, and the sessions have none. Harvest with amodal masks, or choose other boxes."
            );
        }

        if (!HasMasks)
        {
            if (_plan.Options.Boxes == BoxKind.Visible)
            {
                throw new DatasetFormatException(
                    "Boxes of visible pixels need masks, and the sessions have none. Harvest with masks, or choose other boxes."
                );
            }

            return;
        }

        int[] without = [.. Enumerable.Range(0, _frames.Length).Where(session => _masks[session] < _frames[session])];
        if (!DependsOnMasks || without.Length == 0)
        {
            return;
        }

        string reason =
            _masks[without[0]] > 0
                ? $"'{FolderOf(without[0])}' has masks for {_masks[without[0]]} of {Counted.Of(_frames[without[0]], "frame")}"
                : $"'{FolderOf(without[0])}' has no masks, and '{FolderOf(Array.FindIndex(_masks, masks => masks > 0))}' has";
        throw new DatasetFormatException($"Labels would not be comparable: {reason}. Export sessions with and without masks separately.");
    }

    private void CheckClassMaps()
    {
        int without = Enumerable.Range(0, _frames.Length).FirstOrDefault(session => _classMaps[session] < _frames[session], -1);
        if (Format.UsesClassMaps && without >= 0 && _classMaps.Sum() > 0)
        {
            throw new DatasetFormatException(
                $"Labels would not be comparable: '{FolderOf(without)}' has class maps for {_classMaps[without]} of "
                    + $"{Counted.Of(_frames[without], "frame")}, and other frames have them. Export them separately."
            );
        }
    }

    private string AdviceFor(SplitPlan splits)
    {
        if (splits.BlockFrames is not { } blockFrames)
        {
            int places = _written.DistinctBy(frame => (frame.Session, frame.Place)).Count();
            string few = $"each place stays in one split, and the sessions have {Counted.Of(places, "place")}. ";
            return few
                + (
                    splits.FirstFullSeed(_written) is { } seed ? FormattableString.Invariant($"Use --seed {seed}.")
                    : Format.KeepsSequences ? "Add sessions or places, or use fewer splits."
                    : "Add sessions or places, or use --split-block N, which separates frames that look alike."
                );
        }

        string frames = $"{Counted.Of(_written.Count, "frame")}, assigned in blocks of {blockFrames}. ";
        return frames
            + (
                splits.LargestFullBlock(_written) is { } block
                    ? $"Use --split-block {block} or another --seed."
                    : "Use another --seed, or fewer splits."
            );
    }

    private string FolderOf(int session) => _plan.Sessions[session].Folder;
}
