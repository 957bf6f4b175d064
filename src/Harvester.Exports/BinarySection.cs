namespace Harvester.Exports;

/// <summary>Bytes that follow from all parts.</summary>
internal sealed class BinarySection(string part, Action<Stream, IEnumerable<string>> write) : AggregateSection
{
    internal override void Write(IAggregateOutput output) => write(output.Bytes, output.Parts(part));
}
