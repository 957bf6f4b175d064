using Harvester.Sessions.Reading;

namespace Harvester.Exports;

/// <summary>A dataset format of the export command.</summary>
/// <param name="Name">Name on the command line.</param>
/// <param name="Description">A short description.</param>
/// <param name="CreateWriter">Creates its writer.</param>
public sealed record DatasetFormat(string Name, string Description, Func<ExportOptions, IDatasetWriter> CreateWriter)
{
    /// <summary>Checks a dataset of this format and returns its problems.</summary>
    internal Func<DatasetContent, IEnumerable<SessionProblem>> Check { get; init; } = _ => [];

    /// <summary>The program that must be installed to write it; null if none.</summary>
    internal string? Program { get; init; }

    /// <summary>Whether it requires instance masks.</summary>
    public bool NeedsMasks { get; init; }

    /// <summary>Whether it requires class maps.</summary>
    public bool NeedsClassMaps { get; init; }

    /// <summary>Whether its labels depend on class maps, so that sessions with and without them cannot be mixed.</summary>
    public bool UsesClassMaps { get; init; }

    /// <summary>Whether it requires lanes.</summary>
    public bool NeedsLanes { get; init; }

    /// <summary>Whether its labels depend on masks, so that sessions with and without masks cannot be mixed.</summary>
    public bool UsesMasks { get; init; }

    /// <summary>Whether the lane lines of a frame can be chosen.</summary>
    public bool HasLaneSelection { get; init; }

    /// <summary>Whether it has the lanes of a map, made from the roads of the session or of a file.</summary>
    public bool HasMap { get; init; }

    /// <summary>Whether it has the points of LiDARs.</summary>
    public bool HasPoints { get; init; }

    /// <summary>Whether frames without known lanes are left out.</summary>
    public bool LeavesOutUnknownLanes { get; init; }

    /// <summary>Whether it requires the flow from the frame before; frames without are left out.</summary>
    public bool NeedsFlow { get; init; }

    /// <summary>Whether it requires the samples of the inertial unit.</summary>
    public bool NeedsImu { get; init; }

    /// <summary>Whether it requires the voxels around the vehicle.</summary>
    public bool NeedsOccupancy { get; init; }

    /// <summary>Whether its objects have one 2D box, of a kind that can be chosen.</summary>
    public bool HasBoxes { get; init; }

    /// <summary>Whether boxes may reach beyond the image.</summary>
    public bool HasBoxesBeyondImage { get; init; }

    /// <summary>Whether it can mark objects of unknown occlusion, instead of leaving them out.</summary>
    public bool KeepsUndetermined { get; init; }

    /// <summary>Whether its classes can be renamed.</summary>
    public bool HasNames { get; init; }

    /// <summary>The only names that classes can have; null for any.</summary>
    public IReadOnlyCollection<string>? Names { get; init; }

    /// <summary>Whether signs and lights can be split into subclasses.</summary>
    public bool HasSubclasses { get; init; }

    /// <summary>The default selection of objects and parts.</summary>
    public PartSelection DefaultParts { get; init; }

    /// <summary>Whether it cannot represent lens distortion.</summary>
    public bool NeedsRectilinear { get; init; }

    /// <summary>Whether it lists objects; lane formats and class maps do not.</summary>
    public bool HasObjects => ListsObjects && !NeedsLanes && !NeedsClassMaps;

    /// <summary>Whether a two-wheeler and its rider are one object of it.</summary>
    internal bool IncludesRiders { get; init; }

    /// <summary>Whether it lists objects of its images; formats of points and poses do not.</summary>
    internal bool ListsObjects { get; init; } = true;

    /// <summary>Whether it lists faces of signs and heads of lights, which are parts of other objects.</summary>
    public bool HasParts { get; init; }

    /// <summary>Whether posts whose faces or heads are exported instead are labelled as poles.</summary>
    public bool HasPoles { get; init; }

    /// <summary>Whether the encoding of masks can be chosen.</summary>
    public bool HasSegmentations { get; init; }

    /// <summary>Whether the sessions' images become files of the dataset unchanged.</summary>
    public bool KeepsImages { get; init; } = true;

    /// <summary>Whether the frames of a place stay together as one sequence, so that splits never divide a place.</summary>
    public bool KeepsSequences { get; init; }

    /// <summary>The least number of moments per second that it can represent; 0 for any.</summary>
    public double MinRateHz { get; init; }

    /// <summary>The names that a split has in the dataset; no two splits may share one.</summary>
    internal Func<string, IReadOnlyList<string>> SplitNames { get; init; } = split => [split];

    /// <summary>Why the format cannot keep some splits apart, as a sentence; null if it can.</summary>
    /// <param name="splits">The splits.</param>
    public string? ProblemOf(IEnumerable<DatasetSplit> splits)
    {
        var owners = new Dictionary<string, string>(StringComparer.OrdinalIgnoreCase);
        foreach (string split in splits.Select(split => split.Name))
        {
            if (Card is not null && split == DatasetCard.AllSplits)
            {
                return $"The Hugging Face hub calls all splits together '{split}', so no split in {Name} can have this name.";
            }

            foreach (string name in Card is null ? SplitNames(split) : [DatasetCard.NameOf(split)])
            {
                if (!owners.TryAdd(name, split))
                {
                    return $"In {Name}, the splits '{owners[name]}' and '{split}' would share the name '{name}'. Rename one of them.";
                }
            }
        }

        return null;
    }

    /// <summary>How the Hugging Face hub reads it; null if the hub has no reader for it.</summary>
    internal DatasetCard? Card { get; init; }
}
