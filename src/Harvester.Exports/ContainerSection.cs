namespace Harvester.Exports;

/// <summary>A file around the content of staged files.</summary>
internal sealed class ContainerSection(string part, Action<Stream, IEnumerable<byte[]>> write) : AggregateSection
{
    internal override void Write(IAggregateOutput output) => write(output.Bytes, output.Parts(part).Select(output.Staged));
}
