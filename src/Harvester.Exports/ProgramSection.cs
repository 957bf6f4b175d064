using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports;

/// <summary>A file that another program writes from staged files. It is written in the working folder, and copied.</summary>
internal sealed class ProgramSection(string part, Action<string, IEnumerable<string>> write) : AggregateSection
{
    internal override void Write(IAggregateOutput output)
    {
        string made = output.WorkingFile;
        try
        {
            write(made, output.Parts(part).Select(output.PathOfStaged));
            using FileStream file = InputFile.OpenRead(made);
            file.CopyTo(output.Bytes);
        }
        finally
        {
            File.Delete(made);
        }
    }
}
