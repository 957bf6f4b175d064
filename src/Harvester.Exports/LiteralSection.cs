namespace Harvester.Exports;

/// <summary>A fixed text.</summary>
internal sealed class LiteralSection(string text) : AggregateSection
{
    internal override void Write(IAggregateOutput output) => output.Text.Write(text);
}
