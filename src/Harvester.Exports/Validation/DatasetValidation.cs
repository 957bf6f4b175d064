using Harvester.Sessions.Reading;

namespace Harvester.Exports.Validation;

/// <summary>The result of validating an exported dataset.</summary>
/// <param name="Format">Name of the format.</param>
/// <param name="Frames">Number of frames.</param>
/// <param name="Problems">All problems; empty for a valid dataset.</param>
public sealed record DatasetValidation(string Format, int Frames, IReadOnlyList<SessionProblem> Problems)
{
    /// <summary>Whether the dataset has a manifest.</summary>
    public bool HasManifest { get; init; }

    /// <summary>Files in the folder that are no part of the dataset and that its readers ignore, such as caches.</summary>
    public IReadOnlyList<string> OtherFiles { get; init; } = [];
}
