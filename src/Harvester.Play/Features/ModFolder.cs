using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>
/// The files beside the mod. If one cannot be read, <see cref="Complaints"/> says so and defaults are used; nothing is thrown.
/// </summary>
public sealed class ModFolder
{
    /// <summary>Name of the table of faces that the mod comes with.</summary>
    public const string FacesFile = "spaces_of_interest.csv";

    private const string SettingsFile = "GtaDataHarvester.ini";
    private const int MaxRigBytes = 1024 * 1024;
    private readonly string _folder;
    private readonly List<string> _complaints = [];

    /// <summary>Reads the files.</summary>
    /// <param name="folder">The folder of the mod.</param>
    public ModFolder(string folder)
    {
        _folder = folder;
        Settings = Read(ReadSettings, () => IniFile.Read(TextReader.Null), SettingsFile);
        ShippedFaces = ReadFaces(Path.Combine(folder, FacesFile), FacesFile);
        string materials = Path.Combine(folder, MaterialTable.FileName);
        Materials = File.Exists(materials)
            ? Read(() => ReadMaterials(materials), () => MaterialTable.BuiltIn, MaterialTable.FileName)
            : MaterialTable.BuiltIn;
        (Rig, RigProblem) = ReadRig(Settings.Text("Harvest", "Rig", string.Empty));
    }

    /// <summary>Path of the settings file.</summary>
    public string SettingsPath => Path.Combine(_folder, SettingsFile);

    /// <summary>Path of the list of entities that are hidden, which exists only while some are.</summary>
    public string HiddenPath => Path.Combine(_folder, "GtaDataHarvester.hidden");

    /// <summary>The settings.</summary>
    public IniFile Settings { get; }

    /// <summary>The faces of signs and traffic lights shipped with the mod.</summary>
    public FaceTable ShippedFaces { get; }

    /// <summary>The classes of materials: those of the table beside the mod, if there is one.</summary>
    public MaterialTable Materials { get; }

    /// <summary>The rig that the settings name; null without one.</summary>
    public Rig? Rig { get; }

    /// <summary>Why the rig that the settings name cannot be used, as a sentence; null if it can, or none is named.</summary>
    public string? RigProblem { get; }

    /// <summary>The problems of the files, one sentence each; complete after all settings have been read.</summary>
    public IEnumerable<string> Complaints => _complaints.Concat(Settings.Complaints.Select(Told));

    /// <summary>The faces of signs and traffic lights: the player's own, and for other models the shipped ones.</summary>
    /// <param name="measured">The folder with the player's measurements; it need not exist.</param>
    public FaceTable FacesWith(string measured)
    {
        string table = Path.Combine(measured, SurveyFolder.TableName);
        return File.Exists(table) ? ShippedFaces.OverriddenBy(ReadFaces(table, table)) : ShippedFaces;
    }

    /// <summary>Adds a complaint about a setting.</summary>
    public void Complain(string sentence) => _complaints.Add(Told(sentence));

    private (Rig? Rig, string? Problem) ReadRig(string name)
    {
        if (name.Length == 0)
        {
            return (null, null);
        }

        try
        {
            string path = Path.Combine(_folder, Environment.ExpandEnvironmentVariables(name));
            return new FileInfo(path) is { Exists: true, Length: <= MaxRigBytes }
                ? (RigParser.Parse(File.ReadAllText(path)), null)
                : (null, Told($"Rig: there is no file {name} of at most {MaxRigBytes / 1024} KiB beside the mod."));
        }
#pragma warning disable CA1031 // As in Read; a harvest with another rig than the player wants is refused.
        catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
        {
            return (null, Told($"Rig: {name} cannot be used: {exception.Message}"));
        }
    }

    private static string Told(string sentence) => $"{SettingsFile}: {sentence}";

    private IniFile ReadSettings()
    {
        using TextReader reader = File.Exists(SettingsPath) ? new StreamReader(SettingsPath) : TextReader.Null;
        return IniFile.Read(reader);
    }

    private static MaterialTable ReadMaterials(string path)
    {
        using var reader = new StreamReader(path);
        return MaterialTable.Read(reader);
    }

    private FaceTable ReadFaces(string path, string name)
    {
        FaceTableContent content = Read(
            () =>
            {
                using var reader = new StreamReader(path);
                return FaceTableReader.Read(reader);
            },
            () => new FaceTableContent(FaceTable.Empty, []),
            name
        );
        _complaints.AddRange(content.Problems.Select(problem => $"{name}: {problem}"));
        return content.Table;
    }

    private T Read<T>(Func<T> read, Func<T> fallback, string file)
    {
        try
        {
            return read();
        }
#pragma warning disable CA1031 // The mod starts even if a file is damaged.
        catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
        {
            _complaints.Add($"{file} cannot be read: {exception.Message}");
            return fallback();
        }
    }
}
