using System.Collections.Generic;
using Harvester.Datasets.Sessions;

namespace Harvester.Datasets.Exports.Validation;

/// <summary>What a validation of an exported dataset found.</summary>
/// <param name="Format">Its format.</param>
/// <param name="Frames">How many frames it has.</param>
/// <param name="Problems">All that is wrong; empty for a good dataset.</param>
public sealed record DatasetValidation(string Format, int Frames, IReadOnlyList<SessionProblem> Problems);
