using System.Collections.Generic;

namespace Harvester.Sessions.Faces;

/// <summary>What was read of a table: the good rows, and why the others were refused.</summary>
/// <param name="Table">A table of the valid rows.</param>
/// <param name="Problems">The refused rows, in the order of the file.</param>
public sealed record FaceTableContent(FaceTable Table, IReadOnlyList<FaceTableProblem> Problems)
{
    /// <summary>Whether a line with the names of the columns was among what was read; only the project's own form has one.</summary>
    public bool HasHeader { get; init; }
}
