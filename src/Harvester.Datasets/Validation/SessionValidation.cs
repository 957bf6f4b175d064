using System.Collections.Generic;
using Harvester.Datasets.Sessions;

namespace Harvester.Datasets.Validation;

/// <summary>What a validation found.</summary>
/// <param name="Info">What session.json says; null when it cannot be read.</param>
/// <param name="Frames">Frames whose labels could be read.</param>
/// <param name="Objects">Objects in them.</param>
/// <param name="Problems">All that is wrong, in the order of the files; empty for a good session.</param>
public sealed record SessionValidation(SessionInfo? Info, int Frames, int Objects, IReadOnlyList<SessionProblem> Problems)
{
    /// <summary>Labels of which it is not known whether anything of the object is seen.</summary>
    public int Undetermined { get; init; }

    /// <summary>Ignore regions of objects of which it could not be determined whether they are seen.</summary>
    public int UndeterminedRegions { get; init; }

    /// <summary>Whether nothing is wrong.</summary>
    public bool IsGood => Problems.Count == 0;
}
