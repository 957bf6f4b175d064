using System;
using System.Collections.Generic;
using Harvester.Datasets.Sessions;

namespace Harvester.Datasets.Exports;

/// <summary>A dataset format as people choose it.</summary>
/// <param name="Name">Its name on the command line.</param>
/// <param name="Description">What it is, in a few words.</param>
/// <param name="CreateWriter">Makes its writer.</param>
public sealed record DatasetFormat(string Name, string Description, Func<ExportOptions, IDatasetWriter> CreateWriter)
{
    /// <summary>Looks at a dataset of this format and says what is wrong with it.</summary>
    internal Func<DatasetContent, IEnumerable<SessionProblem>> Check { get; init; } = _ => [];

    /// <summary>Whether it cannot do without instance masks.</summary>
    public bool NeedsMasks { get; init; }

    /// <summary>Whether it is about lanes and cannot do without them.</summary>
    public bool NeedsLanes { get; init; }

    /// <summary>
    /// Whether its labels follow the masks where there are masks, so that sessions with and without masks cannot be mixed.
    /// </summary>
    public bool UsesMasks { get; init; }

    /// <summary>Whether it leaves out frames whose lanes are not known.</summary>
    public bool LeavesOutUnknownLanes { get; init; }

    /// <summary>Whether its objects have one box, of which there are several kinds.</summary>
    public bool HasBoxes { get; init; }

    /// <summary>Whether a box may reach beyond the image.</summary>
    public bool HasBoxesBeyondImage { get; init; }

    /// <summary>Whether it says of an object that its occlusion was not determined, instead of leaving the object out.</summary>
    public bool KeepsUndetermined { get; init; }

    /// <summary>Whether its classes can have other names.</summary>
    public bool HasNames { get; init; }

    /// <summary>The only names that classes can have; null for any.</summary>
    public IReadOnlyCollection<string>? Names { get; init; }

    /// <summary>Whether signs and lights can be divided into classes by what they show.</summary>
    public bool HasSubclasses { get; init; }

    /// <summary>What of objects and their parts is exported unless something else is asked for.</summary>
    public PartSelection DefaultParts { get; init; }

    /// <summary>Whether it has no words for a lens that bends lines.</summary>
    public bool NeedsRectilinear { get; init; }

    /// <summary>Whether it lists objects; lanes are all that formats about lanes have.</summary>
    public bool HasObjects => !NeedsLanes;

    /// <summary>Whether it lists the faces of signs and the heads of lights, which are parts of other objects.</summary>
    public bool HasParts { get; init; }

    /// <summary>Whether pixels can be described in one way or another.</summary>
    public bool HasSegmentations { get; init; }

    /// <summary>Whether the sessions' images are files of the dataset as they are.</summary>
    public bool KeepsImages { get; init; } = true;

    /// <summary>Whether a session stays together as one sequence, so that splits deal out sessions.</summary>
    public bool KeepsSessions { get; init; }
}
