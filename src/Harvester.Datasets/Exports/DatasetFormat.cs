using System;
using System.Collections.Generic;
using Harvester.Datasets.Exports.Validation;
using Harvester.Datasets.Validation;

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

    /// <summary>Whether it has no words for a lens that bends lines.</summary>
    public bool NeedsRectilinear { get; init; }

    /// <summary>Whether it lists objects; lanes are all that formats about lanes have.</summary>
    public bool HasObjects => !NeedsLanes;

    /// <summary>Whether it lists the faces of signs and the heads of lights, which are parts of other objects and have no pixels of their own in masks.</summary>
    public bool HasParts { get; init; }

    /// <summary>Whether pixels can be described in one way or another.</summary>
    public bool HasSegmentations { get; init; }

    /// <summary>Whether the sessions' images are files of the dataset as they are.</summary>
    public bool KeepsImages { get; init; } = true;

    /// <summary>Whether a session stays together as one sequence, so that splits deal out sessions.</summary>
    public bool KeepsSessions { get; init; }
}
