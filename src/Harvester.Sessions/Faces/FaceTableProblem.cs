namespace Harvester.Sessions.Faces;

/// <summary>Why a row of a table was rejected.</summary>
/// <param name="Line">Number of the line in the file, from 1.</param>
/// <param name="Column">Name of the column at fault, or several separated by commas; "row" for the whole row.</param>
/// <param name="Reason">What is wrong with it, as a sentence.</param>
public sealed record FaceTableProblem(int Line, string Column, string Reason)
{
    /// <summary>Line, column and reason in one line.</summary>
    public override string ToString() => System.FormattableString.Invariant($"line {Line}, {Column}: {Reason}");
}
