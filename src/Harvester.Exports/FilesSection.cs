namespace Harvester.Exports;

/// <summary>The content of staged files, concatenated.</summary>
internal sealed class FilesSection(string part) : AggregateSection
{
    internal override void Write(IAggregateOutput output)
    {
        foreach (string path in output.Parts(part))
        {
            output.CopyStaged(path);
        }
    }
}
