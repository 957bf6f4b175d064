namespace Harvester.Exports;

/// <summary>Parts, with a text between them and one after each.</summary>
internal sealed class PartsSection(string part, string between, string after) : AggregateSection
{
    internal override void Write(IAggregateOutput output)
    {
        string before = "";
        foreach (string text in output.Parts(part))
        {
            output.Text.Write(before);
            output.Text.Write(text);
            output.Text.Write(after);
            before = between;
        }
    }
}
