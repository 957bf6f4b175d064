namespace Harvester.Sessions.Faces;

/// <summary>Why a row of a table was refused.</summary>
/// <param name="Line">Number of the line in the file, from 1.</param>
/// <param name="Column">Name of the column at fault, or of several with commas between; row where it is the row as a whole.</param>
/// <param name="Reason">What is wrong with it, in words.</param>
public sealed record FaceTableProblem(int Line, string Column, string Reason)
{
    /// <summary>Line, column and reason as one line for people.</summary>
    public override string ToString() => System.FormattableString.Invariant($"line {Line}, {Column}: {Reason}");
}
