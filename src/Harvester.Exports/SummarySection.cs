namespace Harvester.Exports;

/// <summary>A text that follows from all parts.</summary>
internal sealed class SummarySection(string part, Action<TextWriter, IEnumerable<string>> write) : AggregateSection
{
    internal override void Write(IAggregateOutput output) => write(output.Text, output.Parts(part));
}
