#:property PublishAot=false
using System.Text;
using System.Text.Json.Nodes;
using System.Xml.Linq;

// Writes a software bill of materials, CycloneDX 1.5 as JSON, from the assets file that a restore leaves behind.
// It has no serial number and no time, so the same packages give the same bytes. With a system, it also has the runtime of that system.
if (args.Length is not (4 or 5))
{
    Console.Error.WriteLine("Usage: dotnet run build/Sbom.cs -- PROJECT-FOLDER NAME VERSION FILE [SYSTEM]");
    return 2;
}

string name = args[1];
string version = args[2];
JsonNode assets = JsonNode.Parse(File.ReadAllText(Path.Combine(args[0], "obj", "project.assets.json")))!;
string[] packageFolders = [.. assets["packageFolders"]!.AsObject().Select(folder => folder.Key)];
string root = $"{name}@{version}";
JsonArray components = [];
JsonArray references = [];
foreach ((string key, JsonNode? library) in PackagesThatShip(assets))
{
    string[] nameAndVersion = key.Split('/');
    Add("library", nameAndVersion[0], nameAndVersion[1], (string)library!["sha512"]!, LicenceOf((string)library["path"]!));
}

if (args.Length == 5)
{
    // The runtime is a package that the restore downloads; the host, which is the program's first code, has its version. The SDK brings the
    // host of its own system, without the package and its hash.
    foreach (string framework in new[] { "Microsoft.NETCore.App", "Microsoft.AspNetCore.App" })
    {
        string runtime = $"{framework}.Runtime.{args[4]}";
        string runtimeVersion = VersionOfDownload(assets, runtime);
        string path = Path.Combine(runtime.ToLowerInvariant(), runtimeVersion);
        string hash = File.ReadAllText(Path.Combine(FolderOf(path), $"{runtime.ToLowerInvariant()}.{runtimeVersion}.nupkg.sha512"));
        Add("framework", runtime, runtimeVersion, hash, LicenceOf(path));
        if (framework == "Microsoft.NETCore.App")
        {
            Add("framework", $"{framework}.Host.{args[4]}", runtimeVersion, null, LicenceOf(path));
        }
    }
}

JsonObject bom = new()
{
    ["bomFormat"] = "CycloneDX",
    ["specVersion"] = "1.5",
    ["version"] = 1,
    ["metadata"] = new JsonObject
    {
        ["component"] = new JsonObject
        {
            ["type"] = "application",
            ["bom-ref"] = root,
            ["name"] = name,
            ["version"] = version,
            ["licenses"] = new JsonArray(new JsonObject { ["expression"] = "MIT" }),
        },
    },
    ["components"] = components,
    ["dependencies"] = new JsonArray(new JsonObject { ["ref"] = root, ["dependsOn"] = references }),
};

string temporary = args[3] + ".partial";
Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(temporary))!);
File.WriteAllText(temporary, bom.ToJsonString(new() { WriteIndented = true, NewLine = "\n" }) + "\n", new UTF8Encoding(false));
File.Move(temporary, args[3], overwrite: true);
Console.WriteLine(args[3]);
return 0;

void Add(string type, string component, string componentVersion, string? sha512, string licence)
{
    string url = $"pkg:nuget/{component}@{componentVersion}";
    JsonObject added = new()
    {
        ["type"] = type,
        ["bom-ref"] = url,
        ["name"] = component,
        ["version"] = componentVersion,
    };
    if (sha512 is not null)
    {
        added["hashes"] = new JsonArray(
            new JsonObject { ["alg"] = "SHA-512", ["content"] = Convert.ToHexStringLower(Convert.FromBase64String(sha512)) }
        );
    }

    added["licenses"] = new JsonArray(new JsonObject { ["expression"] = licence });
    added["purl"] = url;
    components.Add(added);
    references.Add(url);
}

// The version is a range of one, such as [10.0.1, 10.0.1].
static string VersionOfDownload(JsonNode assets, string package) =>
    assets["project"]!["frameworks"]!
        .AsObject()
        .SelectMany(framework => framework.Value!["downloadDependencies"]!.AsArray())
        .Where(download => (string)download!["name"]! == package)
        .Select(download => ((string)download!["version"]!).Trim('[', ']').Split(',')[0])
        .First();

// Reference assemblies have no file for the runtime.
static IEnumerable<KeyValuePair<string, JsonNode?>> PackagesThatShip(JsonNode assets)
{
    HashSet<string> shipped =
    [
        .. assets["targets"]!
            .AsObject()
            .SelectMany(target => target.Value!.AsObject())
            .Where(library => (string)library.Value!["type"]! == "package" && library.Value!["runtime"] is JsonObject)
            .Select(library => library.Key),
    ];
    return assets["libraries"]!
        .AsObject()
        .Where(library => shipped.Contains(library.Key))
        .OrderBy(library => library.Key, StringComparer.Ordinal);
}

string FolderOf(string packagePath) => packageFolders.Select(parent => Path.Combine(parent, packagePath)).First(Directory.Exists);

string LicenceOf(string packagePath)
{
    XElement package = XDocument.Load(Directory.EnumerateFiles(FolderOf(packagePath), "*.nuspec").Single()).Root!;
    XElement? licence = package.Descendants().FirstOrDefault(element => element.Name.LocalName == "license");
    if (licence?.Attribute("type")?.Value == "expression")
    {
        return licence.Value;
    }

    // Older packages link to the text of their licence.
    return package.Descendants().FirstOrDefault(element => element.Name.LocalName == "licenseUrl")?.Value switch
    {
        "https://github.com/MiloszKrajewski/K4os.Compression.LZ4/blob/master/LICENSE?raw=true" => "MIT",
        _ => throw new InvalidDataException($"{packagePath}: the package states no licence that is known; add a rule to build/Sbom.cs."),
    };
}
