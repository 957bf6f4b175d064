using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Validation;

/// <summary>The result of validating a session.</summary>
/// <param name="Info">The content of session.json; null if it cannot be read.</param>
/// <param name="Frames">Number of frames with readable labels.</param>
/// <param name="Objects">Number of objects in them.</param>
/// <param name="Problems">All problems, in the order of the files; empty for a valid session.</param>
public sealed record SessionValidation(SessionInfo? Info, int Frames, int Objects, IReadOnlyList<SessionProblem> Problems)
{
    /// <summary>Number of labels of objects whose visibility is unknown.</summary>
    public int Undetermined { get; init; }

    /// <summary>Number of ignore regions of objects whose visibility could not be determined.</summary>
    public int UndeterminedRegions { get; init; }

    /// <summary>Whether the session has a manifest.</summary>
    public bool HasManifest { get; init; }

    /// <summary>Whether there are no problems.</summary>
    public bool IsGood => Problems.Count == 0;
}
